// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proof/comparewords.h"
#include "proof/verification.h"

#include <QByteArray>
#include <QElapsedTimer>
#include <QImage>
#include <QSizeF>
#include <memory>
#include <vector>

namespace Poppler {
class Document;
class Page;
} // namespace Poppler

namespace palmer::ui {

/// The pages of a PDF as another program reads them (poppler): words, pictures, signatures. Throws Error for
/// what cannot be read, and for pages that take longer than half a minute in all.
class PdfPages {
public:
    explicit PdfPages(const QByteArray &pdf);
    ~PdfPages();
    PdfPages(const PdfPages &) = delete;
    PdfPages &operator=(const PdfPages &) = delete;

    [[nodiscard]] int count() const;
    [[nodiscard]] QSizeF size(int index) const; ///< points
    /// The words of a page in the order of reading.
    [[nodiscard]] PrintedWords words(int index) const;
    /// A page without annotations, a pixel a point.
    [[nodiscard]] QImage picture(int index) const;
    [[nodiscard]] std::vector<SignatureStatement> signatures() const;

private:
    [[nodiscard]] std::unique_ptr<Poppler::Page> page(int index) const;
    void demandInTime() const;

    std::unique_ptr<Poppler::Document> m_document;
    QElapsedTimer m_since;
};

} // namespace palmer::ui
