// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>
#include <QString>
#include <memory>
#include <string_view>

namespace palmer {

/// Start of an element; names without prefixes. Valid during the call of the handler.
struct XmlElement {
    std::string_view name;
    const char *const *attributes = nullptr; ///< alternating names and values, UTF-8; null-terminated

    /// Empty if there is none.
    [[nodiscard]] std::string_view attribute(std::string_view wanted) const;
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

protected:
    ZipFile() = default;
};

/// Uses libzip. The bytes must outlive the archive. Throws Error(content) for data that are damaged or not an
/// archive.
[[nodiscard]] std::unique_ptr<ZipFile> openZip(QByteArrayView bytes);

inline std::string_view localName(const char *name) {
    if (name[0] != 0 && name[1] == 0) // most names in sheets
        return {name, 1};
    const std::string_view all(name);
    return all.substr(all.find(':') + 1); // npos + 1 is 0
}

inline std::string_view XmlElement::attribute(std::string_view wanted) const {
    for (const char *const *each = attributes; *each; each += 2) {
        if (localName(each[0]) == wanted)
            return each[1];
    }
    return {};
}

} // namespace palmer
