// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/proof/pdfpages.h"

#include "proof/deviation.h"

#include <QDateTime>
#include <poppler/qt6/poppler-form.h>
#include <poppler/qt6/poppler-qt6.h>

namespace palmer {

namespace {

// Poppler calls back after every tenth operator. A report has some thousand operators per page; malicious
// nested forms a billion. Unlike a time limit, this does not depend on the speed of the machine.
constexpr int operatorsOfAnAsking = 10;
constexpr qint64 askingsOfDocument = 200'000;
constexpr qint64 askingsOfPage = 4'000;

bool isTooMuch(const QVariant &left) {
    return --*left.value<qint64 *>() < 0;
}

SignatureStatement::State stateOf(Poppler::SignatureValidationInfo::SignatureStatus status) {
    using Info = Poppler::SignatureValidationInfo;
    switch (status) {
    case Info::SignatureValid:
        return SignatureStatement::State::valid;
    case Info::SignatureInvalid:
    case Info::SignatureDigestMismatch:
    case Info::SignatureDecodingError:
        return SignatureStatement::State::broken;
    default:
        return SignatureStatement::State::unknown;
    }
}

class PagesOfPoppler : public PdfPages {
public:
    explicit PagesOfPoppler(const QByteArray &pdf);

    [[nodiscard]] int count() const override;
    [[nodiscard]] QSizeF size(int index) const override;
    [[nodiscard]] PrintedWords words(int index) const override;
    [[nodiscard]] QImage picture(int index) const override;
    [[nodiscard]] std::vector<SignatureStatement> signatures() const override;

private:
    [[nodiscard]] std::unique_ptr<Poppler::Page> page(int index) const;
    [[nodiscard]] qint64 askings() const {
        return askingsOfDocument + askingsOfPage * m_document->numPages();
    }
    void requireNotTooMuch() const;

    std::unique_ptr<Poppler::Document> m_document;
    mutable qint64 m_left = 0; ///< callbacks until the PDF draws too much
};

PagesOfPoppler::PagesOfPoppler(const QByteArray &pdf) {
    Poppler::setDebugErrorFunction([](const QString &, const QVariant &) {}, {});
    m_document = Poppler::Document::loadFromData(pdf);
    if (!m_document || m_document->isLocked())
        throw unreadablePages();
    m_left = askings();
    m_document->setRenderHint(Poppler::Document::Antialiasing);
    m_document->setRenderHint(Poppler::Document::TextAntialiasing);
    m_document->setRenderHint(Poppler::Document::HideAnnotations);
}

int PagesOfPoppler::count() const {
    return m_document->numPages();
}

void PagesOfPoppler::requireNotTooMuch() const {
    if (m_left < 0)
        throw tooMuchDrawn(operatorsOfAnAsking * askings());
}

std::unique_ptr<Poppler::Page> PagesOfPoppler::page(int index) const {
    auto result = m_document->page(index);
    if (!result)
        throw unreadablePages();
    return result;
}

QSizeF PagesOfPoppler::size(int index) const {
    return page(index)->pageSizeF();
}

PrintedWords PagesOfPoppler::words(int index) const {
    PrintedWords result;
    const QVariant left = QVariant::fromValue(&m_left);
    for (const auto &box : page(index)->textList(Poppler::Page::Rotate0, isTooMuch, left))
        result.push_back({box->text(), box->boundingBox()});
    requireNotTooMuch();
    return result;
}

QImage PagesOfPoppler::picture(int index) const {
    constexpr double dotsPerInch = 72;
    const QVariant left = QVariant::fromValue(&m_left);
    const QImage image = page(index)->renderToImage(
        dotsPerInch, dotsPerInch, -1, -1, -1, -1, Poppler::Page::Rotate0, nullptr, nullptr, isTooMuch, left);
    requireNotTooMuch();
    return image.convertToFormat(QImage::Format_RGB32);
}

std::vector<SignatureStatement> PagesOfPoppler::signatures() const {
    using Info = Poppler::SignatureValidationInfo;
    using SignatureField = Poppler::FormFieldSignature;
    std::vector<SignatureStatement> result;
    for (const auto &field : m_document->signatures()) {
        if (field->signatureType() == SignatureField::UnsignedSignature)
            continue;
        // No network access.
        const Info info = field->validate(SignatureField::ValidateVerifyCertificate |
                                              SignatureField::ValidateWithoutOCSPRevocationCheck,
                                          QDateTime::currentDateTime());
        SignatureStatement statement;
        statement.signer = info.signerName();
        if (info.signingTime() > 0)
            statement.time = QDateTime::fromSecsSinceEpoch(info.signingTime(), Qt::UTC).toString(Qt::ISODate);
        statement.state = stateOf(info.signatureStatus());
        statement.whole = info.signsTotalDocument();
        statement.trusted = info.certificateStatus() == Info::CertificateTrusted;
        result.push_back(std::move(statement));
    }
    return result;
}

} // namespace

std::unique_ptr<PdfPages> openPages(const QByteArray &pdf) {
    return std::make_unique<PagesOfPoppler>(pdf);
}

} // namespace palmer
