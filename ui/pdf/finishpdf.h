#pragma once

#include <QByteArray>
#include <QString>

namespace palmer::ui {

/// What a PDF says about itself.
struct PdfProperties {
    QString title;
    QString author;
    QString language; ///< "en", "fr"
    QString date;     ///< YYYY-MM-DD; empty: the PDF carries none
};

/// Takes out of a PDF what comes from the clock and the machine it was written on, and puts in what the
/// report says: the same pages and properties give the same bytes. Throws std::runtime_error when `pdf` is no
/// PDF.
[[nodiscard]] QByteArray finishPdf(const QByteArray &pdf, const PdfProperties &properties);

} // namespace palmer::ui
