// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/fonts.h"

#include <QFile>
#include <QFontDatabase>
#include <QRawFont>
#include <QResource>
#include <QtEndian>
#include <stdexcept>

namespace palmer {

namespace {

constexpr QLatin1StringView publicFamily("Liberation Sans");

/// By which Qt knows the faces: under their own name it would take those of the system, whatever their
/// version, and the same report would have other bytes on another machine. Of the same length, to be written
/// over the other.
constexpr QLatin1StringView family("Palmer Sans 230");
static_assert(family.size() == publicFamily.size());

QByteArray utf16(QLatin1StringView text) {
    QByteArray bytes;
    for (const char letter : text)
        bytes.append('\0').append(letter);
    return bytes;
}

/// A copy of a TrueType file with the family of its table of names replaced; what it is called in a PDF is
/// another name there, and stays.
QByteArray renamed(QByteArray face) {
    constexpr qsizetype tables = 12; // begin of the list of tables; each: tag, sum, offset, length
    constexpr qsizetype row = 16;
    const auto number = [&face](qsizetype at) { return qFromBigEndian<quint32>(face.constData() + at); };
    const int count = qFromBigEndian<quint16>(face.constData() + 4);
    for (qsizetype at = tables; at < tables + count * row && at + row <= face.size(); at += row) {
        if (face.sliced(at, 4) != "name")
            continue;
        const auto offset = static_cast<qsizetype>(number(at + 8));
        QByteArray names = face.mid(offset, static_cast<qsizetype>(number(at + 12)));
        names.replace(publicFamily.data(), family.data());
        names.replace(utf16(publicFamily), utf16(family));
        face.replace(offset, names.size(), names);
    }
    return face;
}

#ifdef PALMER_FONTS
/// The font file of the distribution.
QByteArray fontFile(const QString &name) {
    QFile file(QStringLiteral(PALMER_FONTS "/") + name);
    if (!file.open(QIODevice::ReadOnly))
        throw std::runtime_error("the font of the reports is missing: " + file.fileName().toStdString());
    return file.readAll();
}
#else
/// The font file as a view of the resource, which exists as long as the program.
QByteArray fontFile(const QString &name) {
    const QResource file(QStringLiteral(":/fonts/") + name);
    if (!file.isValid() || file.compressionAlgorithm() != QResource::NoCompression)
        throw std::runtime_error("the font of the reports is missing");
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of QResource
    return QByteArray::fromRawData(reinterpret_cast<const char *>(file.data()), qsizetype(file.size()));
}
#endif

bool load() {
    // Characters of the texts in both languages and of the symbols of the standards, besides ASCII.
    const QString signs = QStringLiteral("µ±↑↓\u0304°″′éèàùâêîôûçœÉÀ«»’−–—·×²³√α"
                                         "θ\u00a0\u202f");
    for (const char *face : {"Regular", "Bold", "Italic", "BoldItalic"}) {
        const QByteArray data = fontFile(QStringLiteral("LiberationSans-%1.ttf").arg(QLatin1String(face)));
        const int id = QFontDatabase::addApplicationFontFromData(renamed(data));
        if (id < 0 || QFontDatabase::applicationFontFamilies(id).value(0) != family)
            throw std::runtime_error("the font of the reports is damaged");
        const QRawFont raw(data, 10);
        for (const QChar sign : signs) {
            if (!raw.supportsCharacter(sign)) {
                throw std::runtime_error("the font of the reports lacks U+" +
                                         QString::number(sign.unicode(), 16).toStdString());
            }
        }
    }
    return true;
}

} // namespace

void loadFonts() {
    [[maybe_unused]] static const bool loaded = load();
}

QString paperFamily() {
    loadFonts();
    return family;
}

QString printedFamily() {
    return publicFamily;
}

QFont paperFont(int pixelSize, bool bold, bool italic) {
    QFont font(paperFamily());
    font.setPixelSize(pixelSize);
    font.setBold(bold);
    font.setItalic(italic);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

} // namespace palmer
