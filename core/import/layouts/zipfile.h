// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>
#include <QString>
#include <memory>
#include <string_view>

namespace palmer {

/// An element begins; names without their prefixes. Valid as long as the handler is called.
struct XmlElement {
    std::string_view name;
    const char *const *attributes = nullptr; ///< name and value in turn, UTF-8; null at the end

    /// Empty where there is none.
    [[nodiscard]] std::string_view attribute(std::string_view wanted) const;
};

/// What is told of the elements of a part.
class XmlHandler {
public:
    XmlHandler() = default;
    virtual ~XmlHandler() = default;
    XmlHandler(const XmlHandler &) = delete;
    XmlHandler &operator=(const XmlHandler &) = delete;
    virtual void begin(const XmlElement &element) = 0;
    virtual void end(std::string_view name) = 0;
    virtual void text(std::string_view text) = 0; ///< a part of it at a time
};

/// A ZIP archive in memory, read only.
class ZipFile {
public:
    virtual ~ZipFile() = default;
    ZipFile(const ZipFile &) = delete;
    ZipFile &operator=(const ZipFile &) = delete;

    /// Names are compared as those of workbooks are: without regard to case, and to which slash was written.
    [[nodiscard]] virtual bool contains(const QString &name) const = 0;
    /// Walks through the elements of an XML member as it is unpacked; nothing where there is none. Entities
    /// are refused. Throws Error(syntax) with line and column; Error(tooLarge) before more than 256 MiB or
    /// more than a thousand times its compressed size are unpacked, all members together 512 MiB (each counts
    /// once); what the handler throws.
    virtual void walk(const QString &name, XmlHandler &handler) = 0;

protected:
    ZipFile() = default;
};

/// By libzip. The bytes have to live as long. Throws Error(content) for what is no archive or is damaged.
[[nodiscard]] std::unique_ptr<ZipFile> openZip(QByteArrayView bytes);

inline std::string_view localName(const char *name) {
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
