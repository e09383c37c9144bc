// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QCryptographicHash>
#include <QIODevice>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

/// A PDF has no room for more than 4 GB: its list of objects keeps places of four bytes.
struct PdfTooLarge : std::length_error {
    PdfTooLarge()
        : std::length_error("a PDF of more than 4 GB") {}
};

/// Writes the objects of a PDF one by one (ISO 32000-1, 7.5): libqpdf writes only what it holds in memory, a
/// kilobyte each, and a long report has a million of them. Of each object its place is kept, eight bytes.
class PdfFile {
public:
    /// `pack` compresses for FlateDecode; `next`: the first number that no object has.
    PdfFile(QIODevice &device, QByteArray (*pack)(const QByteArray &), int next);

    /// A number for an object that is yet to be written.
    [[nodiscard]] int newNumber() { return m_next++; }

    // Each throws PdfTooLarge where the file would get too large.

    /// Writes an object that is no stream.
    void add(int number, std::string_view object);
    /// Writes a stream; `entries` of its dictionary without its length ("/Filter /FlateDecode").
    void addStream(int number, std::string_view entries, std::string_view data);
    /// The same with these data compressed.
    void addPacked(int number, std::string_view entries, std::string_view data);

    /// Writes what stands at the end of the file, with these entries of the trailer ("/Root 1 0 R"); its
    /// identifiers are made of what was written. Returns false if the device did not accept all bytes.
    [[nodiscard]] bool end(std::string_view trailer);

private:
    struct Place {
        std::uint32_t at = 0;    ///< in the file, or number of the object that holds it
        std::uint16_t index = 0; ///< within that
        std::uint8_t type = 0;   ///< 1: in the file; 2: in another; 0: there is no such object
    };

    void write(std::string_view bytes);
    void setPlace(int number, Place place);
    void writeHeld();
    [[nodiscard]] std::string sections() const;
    [[nodiscard]] std::string places() const;

    QIODevice &m_device;
    QByteArray (*m_pack)(const QByteArray &);
    int m_next;
    std::vector<Place> m_places; ///< by number
    std::vector<int> m_held;     ///< objects of the next object stream
    std::string m_heldPlaces;    ///< "12 0 13 27 "
    std::string m_heldObjects;
    QCryptographicHash m_hash{QCryptographicHash::Md5}; ///< no protection, an identifier
    std::uint32_t m_size = 0;
    bool m_failed = false;
};

} // namespace palmer
