// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace palmer {

// libqpdf behind a wall: its headers are C++17 to clang 14, so what stands here is of the standard library
// alone.

/// A file inside a PDF.
struct EmbeddedFile {
    std::string name; ///< UTF-8
    std::string bytes;
};

/// Something that a report does not have when it is made, and that may show its reader other than what it
/// says.
struct PdfAddition {
    enum class Kind { action, form, attachment, annotation };
    Kind kind = Kind::action;
    int page = 0;     ///< from 1; 0: of the whole file
    std::string name; ///< of the attachment, the key of the PDF
};

/// The place of a signature on a page, points from its top left corner.
struct PdfField {
    int page = 1; ///< from 1
    double left = 0, top = 0, right = 0, bottom = 0;
};

/// The last revision of a PDF.
struct PdfParts {
    bool encrypted = false; ///< then nothing more is read
    std::string xmp;
    std::vector<EmbeddedFile> files; ///< as readers find them, each once
    std::vector<PdfAddition> additions;
    std::vector<PdfField> signatureFields; ///< those that are seen
    std::vector<std::string> beside; ///< what readers show beside the pages: title and author, bookmarks
};

/// Takes a PDF apart. `most`: bytes that its streams may unpack to; `exceeded` says when that was the reason.
/// Throws std::exception for what is damaged: nothing is guessed from a ruin, for what other readers make of
/// it is not known.
[[nodiscard]] PdfParts pdfParts(const char *bytes, std::size_t size, std::int64_t most, bool &exceeded);

} // namespace palmer
