// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/pdffile.h"

#include <algorithm>
#include <concepts>
#include <limits>

namespace palmer {

namespace {

constexpr std::size_t objectsOfAStream = 200;

std::string textOf(std::integral auto number) {
    return std::to_string(number);
}

/// Number with so many bytes, the highest first.
template <int bytes>
void appendBytes(std::string &to, std::uint32_t number) {
    constexpr unsigned bitsOfAByte = 8;
    for (int i = bytes; i-- > 0;)
        to += static_cast<char>((number >> (static_cast<unsigned>(i) * bitsOfAByte)) & 0xffU);
}

} // namespace

PdfFile::PdfFile(QIODevice &device, QByteArray (*pack)(const QByteArray &), int next)
    : m_device(device)
    , m_pack(pack)
    , m_next(next) {
    write("%PDF-1.7\n%\xbf\xf7\xa2\xfe\n"); // a comment that says that the file is binary
}

void PdfFile::write(std::string_view bytes) {
    if (bytes.size() > std::numeric_limits<std::uint32_t>::max() - m_size)
        throw PdfTooLarge();
    const QByteArrayView view(bytes.data(), static_cast<qsizetype>(bytes.size()));
    m_hash.addData(view);
    m_failed = m_failed || m_device.write(view.data(), view.size()) != view.size();
    m_size += static_cast<std::uint32_t>(bytes.size());
}

void PdfFile::setPlace(int number, Place place) {
    const auto index = static_cast<std::size_t>(number);
    if (index >= m_places.size())
        m_places.resize(std::max(index + 1, static_cast<std::size_t>(m_next)));
    m_places[index] = place;
}

void PdfFile::add(int number, std::string_view object) {
    m_heldPlaces += textOf(number) + ' ' + textOf(m_heldObjects.size()) + ' ';
    m_heldObjects += object;
    m_heldObjects += '\n';
    m_held.push_back(number);
    if (m_held.size() == objectsOfAStream)
        writeHeld();
}

void PdfFile::writeHeld() {
    if (m_held.empty())
        return;
    const int number = newNumber();
    for (std::size_t i = 0; i < m_held.size(); ++i)
        setPlace(m_held[i], {static_cast<std::uint32_t>(number), static_cast<std::uint16_t>(i), 2});
    addPacked(number, "/Type /ObjStm /N " + textOf(m_held.size()) + " /First " + textOf(m_heldPlaces.size()),
              m_heldPlaces + m_heldObjects);
    m_held.clear();
    m_heldPlaces.clear();
    m_heldObjects.clear();
}

void PdfFile::addStream(int number, std::string_view entries, std::string_view data) {
    setPlace(number, {m_size, 0, 1});
    write(textOf(number) + " 0 obj\n<< " + std::string(entries) + " /Length " + textOf(data.size()) +
          " >>\nstream\n");
    write(data);
    write("\nendstream\nendobj\n");
}

void PdfFile::addPacked(int number, std::string_view entries, std::string_view data) {
    const QByteArray packed = m_pack(QByteArray(data.data(), static_cast<qsizetype>(data.size())));
    addStream(number, std::string(entries) + " /Filter /FlateDecode",
              {packed.constData(), static_cast<std::size_t>(packed.size())});
}

bool PdfFile::end(std::string_view trailer) {
    writeHeld();
    const int number = newNumber();
    const std::uint32_t at = m_size;
    setPlace(number, {at, 0, 1});
    const std::string id = '<' + m_hash.result().toHex().toStdString() + '>';
    addPacked(number,
              "/Type /XRef /W [1 4 2] /Size " + textOf(m_next) + " /Index [" + sections() + "] /ID [" + id +
                  id + "] " + std::string(trailer),
              places());
    write("startxref\n" + textOf(at) + "\n%%EOF\n");
    return !m_failed;
}

/// First number and length of each run of numbers that objects have.
std::string PdfFile::sections() const {
    std::string result = "0 1"; // the head of the list of free numbers
    for (std::size_t i = 1; i < m_places.size();) {
        std::size_t last = i;
        while (last < m_places.size() && m_places[last].type != 0)
            ++last;
        if (last > i)
            result += ' ' + textOf(i) + ' ' + textOf(last - i);
        i = last + 1;
    }
    return result;
}

std::string PdfFile::places() const {
    std::string result;
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const Place &place = m_places[i];
        if (place.type == 0 && i > 0)
            continue;
        result += static_cast<char>(place.type);
        appendBytes<4>(result, place.at);
        appendBytes<2>(result, i == 0 ? 0xffffU : place.index);
    }
    return result;
}

} // namespace palmer
