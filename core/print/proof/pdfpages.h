// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proof/compare.h"
#include "proof/verification.h"

#include <QByteArray>
#include <QImage>
#include <QSizeF>
#include <memory>
#include <vector>

namespace palmer {

/// The pages of a PDF: words, pictures, signatures. Throws Error if they cannot be read or draw more than a
/// report does.
class PdfPages {
public:
    virtual ~PdfPages() = default;
    PdfPages(const PdfPages &) = delete;
    PdfPages &operator=(const PdfPages &) = delete;

    [[nodiscard]] virtual int count() const = 0;
    [[nodiscard]] virtual QSizeF size(int index) const = 0; ///< points
    /// Words of a page in reading order.
    [[nodiscard]] virtual PrintedWords words(int index) const = 0;
    /// A page without annotations, one pixel per point.
    [[nodiscard]] virtual QImage picture(int index) const = 0;
    [[nodiscard]] virtual std::vector<SignatureStatement> signatures() const = 0;

protected:
    PdfPages() = default;
};

/// The pages as another program (poppler) reads them.
[[nodiscard]] std::unique_ptr<PdfPages> openPages(const QByteArray &pdf);

} // namespace palmer
