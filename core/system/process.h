// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>

class QObject;

namespace palmer {

/// The words after the program's name, whatever their characters.
[[nodiscard]] QStringList wordsOf(int argc, const char *const *argv);

/// Locale of the user: the first of LC_ALL, LC_MESSAGES and LANG that is set, as in POSIX, then what the
/// system says. Empty if nothing does.
[[nodiscard]] QString localeOfUser();

/// The part of it that only the system says; empty where the variables say all.
[[nodiscard]] QString localeOfSystem();

/// A file over its size limit is an error of writing, not the end of the program.
void reportFilesTooLarge();

/// So is a pipe without reader.
void reportBrokenPipes();

/// True if there is a screen for windows. Qt's own options may still choose another.
[[nodiscard]] bool hasScreen();

/// Calls `work` when the system ends the program, which then ends; during the life of `context`.
void onEnd(QObject &context, std::function<void()> work);

/// Name of the processor; empty if the system does not say it.
[[nodiscard]] QString processorName();

} // namespace palmer
