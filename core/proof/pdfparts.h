// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace palmer {

// Isolates libqpdf: its headers are C++17 to clang 14, so this interface uses only the standard library.

/// A file inside a PDF.
struct EmbeddedFile {
    std::string name; ///< UTF-8
    std::string bytes;
};

/// Something that a report does not contain when it is made, and that may make it appear to say something
/// else.
struct PdfAddition {
    enum class Kind { action, form, attachment, annotation };
    Kind kind = Kind::action;
    int page = 0;     ///< from 1; 0: the whole file
    std::string name; ///< of the attachment, or PDF key
};

/// Area of a signature on a page, points from its top left corner.
struct PdfField {
    int page = 1; ///< from 1
    double left = 0, top = 0, right = 0, bottom = 0;
};

/// The last revision of a PDF.
struct PdfParts {
    bool encrypted = false; ///< then nothing else is read
    std::string xmp;
    std::vector<EmbeddedFile> files; ///< as readers find them, without duplicates
    std::vector<PdfAddition> additions;
    std::vector<PdfField> signatureFields; ///< visible ones
    std::vector<std::string> beside; ///< besides the pages: title, author, bookmarks, what is read aloud
};

/// Takes a PDF apart. `most`: bytes that its streams may unpack to; `exceeded`: true if they unpack to more.
/// Throws std::exception if it is damaged: nothing is repaired, since other readers might repair it
/// differently.
[[nodiscard]] PdfParts pdfParts(const char *bytes, std::size_t size, std::int64_t most, bool &exceeded);

} // namespace palmer
