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

/// A format of measurements: how it is called, how it is known by its content, and its reader, which throws
/// Error for what cannot be used.
struct ImportFormat {
    const char *word = nullptr; ///< in --set format=…
    Text name;                  ///< none: nobody asks for it
    const char *endings = "";   ///< of its files, with blanks between: "csv tsv txt"
    bool (*recognises)(QByteArrayView bytes) = nullptr;
    void (*read)(const ImportSource &source, Choices &choices, Imported &imported) = nullptr;
};

/// The formats in the order they are asked in; a table takes what no other recognises.
[[nodiscard]] std::span<const ImportFormat *const> importFormats();

/// The endings of files of measurements, once each: "csv", "xlsx", …
[[nodiscard]] QStringList importEndings();

/// The same for dialogs that choose files: "*.csv *.xlsx …".
[[nodiscard]] QString importPatterns();

} // namespace palmer
