// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/zipfile.h"

#include "document/documenterror.h"

#include <libxml/parser.h>
#include <zip.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace palmer {

namespace {

constexpr qint64 memberLimit = qint64(256) << 20;
constexpr qint64 allLimit = qint64(512) << 20;
constexpr qint64 ratioLimit = 1000; // text in workbooks stays below 100
constexpr Text damaged = REPORT_TEXT(
    "report", "the workbook is damaged or was cut off; save it again, or export the sheet as CSV");

[[noreturn]] void refuseDamaged() {
    throw Error(Error::Kind::content, {damaged});
}

[[noreturn]] void refuseBomb() {
    throw Error(Error::Kind::tooLarge,
                {REPORT_TEXT("report", "the workbook unpacks to more than a table of readings can be")});
}

/// Uses libxml2, block by block.
class XmlParser {
public:
    explicit XmlParser(XmlHandler &handler)
        : m_handler(handler) {
        xmlSAXHandler calls{};
        calls.initialized = XML_SAX2_MAGIC;
        calls.startElementNs = begin;
        calls.endElementNs = end;
        calls.characters = calls.ignorableWhitespace = text;
        calls.internalSubset = refuseEntities;
        m_parser = xmlCreatePushParserCtxt(&calls, this, nullptr, 0, nullptr);
        if (!m_parser)
            throw std::bad_alloc();
        xmlCtxtUseOptions(m_parser, XML_PARSE_NOENT | XML_PARSE_NONET);
    }
    ~XmlParser() { xmlFreeParserCtxt(m_parser); }
    XmlParser(const XmlParser &) = delete;
    XmlParser &operator=(const XmlParser &) = delete;

    void take(const char *block, int size) {
        xmlParseChunk(m_parser, block, size, size == 0);
        if (m_thrown)
            std::rethrow_exception(m_thrown);
        if (!m_parser->wellFormed)
            refuse();
    }

private:
    [[noreturn]] void refuse() {
        throw Error(Error::Kind::syntax, {damaged},
                    std::to_string(m_parser->input->line) + ':' + std::to_string(m_parser->input->col));
    }

    /// Keeps exceptions from passing through the C parser.
    template <class Call>
    void call(Call tell) {
        if (m_thrown)
            return;
        try {
            tell();
        } catch (...) {
            m_thrown = std::current_exception();
            xmlStopParser(m_parser);
        }
    }

    static void begin(void *data, const xmlChar *name, const xmlChar *, const xmlChar *, int,
                      const xmlChar **, int count, int, const xmlChar **attributes) {
        auto &self = *static_cast<XmlParser *>(data);
        self.call([&] {
            constexpr int deepest = 64;
            if (++self.m_depth > deepest)
                self.refuse();
            self.m_handler.begin(
                {inChars(name),
                 {static_cast<const XmlElement::Attribute *>(static_cast<const void *>(attributes)),
                  static_cast<std::size_t>(count)}});
        });
    }
    static void end(void *data, const xmlChar *name, const xmlChar *, const xmlChar *) {
        auto &self = *static_cast<XmlParser *>(data);
        --self.m_depth;
        self.call([&] { self.m_handler.end(inChars(name)); });
    }
    static void text(void *data, const xmlChar *text, int size) {
        auto &self = *static_cast<XmlParser *>(data);
        self.call([&] { self.m_handler.text(inChars(text, size)); });
    }
    static void refuseEntities(void *data, const xmlChar *, const xmlChar *, const xmlChar *) {
        auto &self = *static_cast<XmlParser *>(data);
        self.call([&] { self.refuse(); });
    }

    XmlHandler &m_handler;
    xmlParserCtxtPtr m_parser;
    int m_depth = 0;
    std::exception_ptr m_thrown;
};

class ZipFileOfLibzip : public ZipFile {
public:
    explicit ZipFileOfLibzip(QByteArrayView bytes);
    ~ZipFileOfLibzip() override { zip_discard(m_archive); }
    ZipFileOfLibzip(const ZipFileOfLibzip &) = delete;
    ZipFileOfLibzip &operator=(const ZipFileOfLibzip &) = delete;

    [[nodiscard]] bool contains(const QString &name) const override { return find(name) >= 0; }
    void walk(const QString &name, XmlHandler &handler) override;
    [[nodiscard]] qint64 statedSize(const QString &name) const override;

private:
    /// Sizes of a member, unpacked and the most it may have; the first is 0 if the archive does not state it.
    struct Sizes {
        qint64 stated = 0;
        qint64 most = 0;
    };
    [[nodiscard]] Sizes sizesOf(qint64 index) const;
    [[nodiscard]] qint64 find(const QString &name) const; ///< below 0 if there is none

    zip_t *m_archive = nullptr;
    std::map<qint64, qint64> m_unpacked; ///< bytes, by index
};

ZipFileOfLibzip::ZipFileOfLibzip(QByteArrayView bytes) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t *source =
        zip_source_buffer_create(bytes.data(), static_cast<zip_uint64_t>(bytes.size()), 0, &error);
    m_archive = source ? zip_open_from_source(source, ZIP_RDONLY, &error) : nullptr;
    zip_error_fini(&error);
    if (!m_archive) {
        if (source)
            zip_source_free(source);
        refuseDamaged();
    }
}

qint64 ZipFileOfLibzip::find(const QString &name) const {
    const QByteArray asStated = name.toUtf8();
    const qint64 index = zip_name_locate(m_archive, asStated.constData(), ZIP_FL_NOCASE);
    if (index >= 0)
        return index;
    const QByteArray otherSlashes = QByteArray(asStated).replace('/', '\\');
    return zip_name_locate(m_archive, otherSlashes.constData(), ZIP_FL_NOCASE);
}

ZipFileOfLibzip::Sizes ZipFileOfLibzip::sizesOf(qint64 index) const {
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat_index(m_archive, static_cast<zip_uint64_t>(index), 0, &stat) != 0)
        refuseDamaged();
    const qint64 packed = (stat.valid & ZIP_STAT_COMP_SIZE) ? static_cast<qint64>(stat.comp_size) : 0;
    qint64 left = allLimit;
    for (const auto &[other, size] : m_unpacked)
        left -= other == index ? 0 : size;
    constexpr auto mostStated = static_cast<zip_uint64_t>(std::numeric_limits<qint64>::max());
    return {(stat.valid & ZIP_STAT_SIZE) ? static_cast<qint64>(std::min(stat.size, mostStated)) : 0,
            std::min({memberLimit, left, std::max<qint64>(packed, 1024) * ratioLimit})};
}

qint64 ZipFileOfLibzip::statedSize(const QString &name) const {
    const qint64 index = find(name);
    if (index < 0)
        return 0;
    const auto [stated, most] = sizesOf(index);
    return std::min(stated, most);
}

void ZipFileOfLibzip::walk(const QString &name, XmlHandler &handler) {
    const qint64 index = find(name);
    if (index < 0)
        return;
    const auto [stated, most] = sizesOf(index);
    if (stated > most)
        refuseBomb(); // the actual size is checked below
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t *)> file(
        zip_fopen_index(m_archive, static_cast<zip_uint64_t>(index), 0), zip_fclose);
    if (!file)
        refuseDamaged();
    XmlParser parser(handler);
    std::vector<char> block(1 << 16);
    qint64 unpacked = 0;
    zip_int64_t read = 0;
    do {
        read = zip_fread(file.get(), block.data(), block.size());
        if (read < 0)
            refuseDamaged();
        unpacked += read;
        if (unpacked > most)
            refuseBomb();
        if (unpacked > 0)
            parser.take(block.data(), static_cast<int>(read));
    } while (read > 0);
    m_unpacked[index] = unpacked;
}

} // namespace

std::unique_ptr<ZipFile> openZip(QByteArrayView bytes) {
    return std::make_unique<ZipFileOfLibzip>(bytes);
}

} // namespace palmer
