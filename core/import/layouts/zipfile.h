// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>
#include <QString>
#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

namespace palmer {

inline const char *asChars(const unsigned char *text) {
    return static_cast<const char *>(static_cast<const void *>(text));
}
inline std::string_view inChars(const unsigned char *text, std::ptrdiff_t size) {
    return {asChars(text), static_cast<std::size_t>(size)};
}
inline std::string_view inChars(const unsigned char *name) {
    if (name[0] != 0 && name[1] == 0) // most names in sheets
        return inChars(name, 1);
    return asChars(name);
}

/// Start of an element; names without prefixes. Valid during the call of the handler.
struct XmlElement {
    /// A name, the prefix and address of its namespace, and where its value begins and ends, as libxml2 has
    /// them.
    using Attribute = std::array<const unsigned char *, 5>;

    std::string_view name;
    std::span<const Attribute> attributes;

    static std::string_view nameOf(const Attribute &attribute) { return inChars(attribute[0]); }
    static std::string_view valueOf(const Attribute &attribute) {
        return inChars(attribute[3], attribute[4] - attribute[3]);
    }
    /// Empty if there is none.
    [[nodiscard]] std::string_view attribute(std::string_view wanted) const {
        const auto found = std::ranges::find(attributes, wanted, nameOf);
        return found == attributes.end() ? std::string_view() : valueOf(*found);
    }
};

/// Receives the elements of a part.
class XmlHandler {
public:
    XmlHandler() = default;
    virtual ~XmlHandler() = default;
    XmlHandler(const XmlHandler &) = delete;
    XmlHandler &operator=(const XmlHandler &) = delete;
    virtual void begin(const XmlElement &element) = 0;
    virtual void end(std::string_view name) = 0;
    virtual void text(std::string_view text) = 0; ///< called with partial texts
};

/// A read-only ZIP archive in memory.
class ZipFile {
public:
    virtual ~ZipFile() = default;
    ZipFile(const ZipFile &) = delete;
    ZipFile &operator=(const ZipFile &) = delete;

    /// Names are compared as in workbooks: ignoring case and the kind of slash.
    [[nodiscard]] virtual bool contains(const QString &name) const = 0;
    /// Visits the elements of an XML member while unpacking, if it exists. Refuses entities. Throws
    /// Error(syntax) with line and column; Error(tooLarge) before unpacking more than 256 MiB or a thousand
    /// times its compressed size, or 512 MiB for all members (each counted once); and whatever the handler
    /// throws.
    virtual void walk(const QString &name, XmlHandler &handler) = 0;
    /// In bytes, unpacked, as the archive states it and not more than walk() unpacks; 0 without such a
    /// member.
    [[nodiscard]] virtual qint64 statedSize(const QString &name) const = 0;

protected:
    ZipFile() = default;
};

/// Uses libzip. The bytes must outlive the archive. Throws Error(content) for data that are damaged or not an
/// archive.
[[nodiscard]] std::unique_ptr<ZipFile> openZip(QByteArrayView bytes);

} // namespace palmer
