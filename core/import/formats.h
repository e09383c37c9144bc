// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/text.h"

#include <QByteArrayView>
#include <QStringList>
#include <span>

namespace palmer {

class Choices;
struct Imported;
struct ImportSource;

/// A measurement format: its name, how to recognise its content, and its reader, which throws Error if
/// unusable.
struct ImportFormat {
    const char *word = nullptr; ///< in --set format=…
    Text name;                  ///< empty: not listed for users
    const char *endings = "";   ///< of its files, separated by blanks: "csv tsv txt"
    bool (*recognises)(QByteArrayView bytes) = nullptr;
    void (*read)(const ImportSource &source, Choices &choices, Imported &imported) = nullptr;
};

/// The formats in the order they are tried; a table is whatever no other recognises.
[[nodiscard]] std::span<const ImportFormat *const> importFormats();

/// The file suffixes of measurements, without repetition: "csv", "xlsx", …
[[nodiscard]] QStringList importEndings();

/// The same for file dialogs: "*.csv *.xlsx …".
[[nodiscard]] QString importPatterns();

} // namespace palmer
