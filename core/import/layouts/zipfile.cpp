// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/zipfile.h"

#include "document/documenterror.h"

#include <zip.h>

#include <memory>

namespace palmer {

namespace {

constexpr qint64 memberLimit = qint64(256) << 20;
constexpr qint64 allLimit = qint64(512) << 20;
constexpr qint64 ratioLimit = 1000; // of text in a workbook: below 100
constexpr qint64 blockSize = 1 << 16;

[[noreturn]] void refuseDamaged() {
    throw Error(
        Error::Kind::content,
        {REPORT_TEXT("report",
                     "the workbook is damaged or was cut off; save it again, or export the sheet as CSV")});
}

[[noreturn]] void refuseBomb() {
    throw Error(Error::Kind::tooLarge,
                {REPORT_TEXT("report", "the workbook unpacks to more than a table of readings can be")});
}

class ZipFileOfLibzip : public ZipFile {
public:
    explicit ZipFileOfLibzip(QByteArrayView bytes);
    ~ZipFileOfLibzip() override { zip_discard(m_archive); }
    ZipFileOfLibzip(const ZipFileOfLibzip &) = delete;
    ZipFileOfLibzip &operator=(const ZipFileOfLibzip &) = delete;

    [[nodiscard]] bool contains(const QString &name) const override { return find(name) >= 0; }
    [[nodiscard]] QByteArray member(const QString &name) override;

private:
    [[nodiscard]] qint64 find(const QString &name) const; ///< below 0: there is none

    zip_t *m_archive = nullptr;
    qint64 m_unpacked = 0;
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

QByteArray ZipFileOfLibzip::member(const QString &name) {
    const qint64 index = find(name);
    if (index < 0)
        return {};
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat_index(m_archive, static_cast<zip_uint64_t>(index), 0, &stat) != 0)
        refuseDamaged();
    const qint64 packed = (stat.valid & ZIP_STAT_COMP_SIZE) ? static_cast<qint64>(stat.comp_size) : 0;
    const qint64 most =
        std::min({memberLimit, allLimit - m_unpacked, std::max<qint64>(packed, 1024) * ratioLimit});
    if ((stat.valid & ZIP_STAT_SIZE) && stat.size > static_cast<zip_uint64_t>(most))
        refuseBomb(); // what it says of itself; what it is, is counted below
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t *)> file(
        zip_fopen_index(m_archive, static_cast<zip_uint64_t>(index), 0), zip_fclose);
    if (!file)
        refuseDamaged();
    QByteArray bytes;
    for (;;) {
        const qsizetype size = bytes.size();
        bytes.resize(size + blockSize);
        const zip_int64_t read =
            zip_fread(file.get(), bytes.data() + size, static_cast<zip_uint64_t>(blockSize));
        if (read < 0)
            refuseDamaged();
        bytes.resize(size + static_cast<qsizetype>(read));
        if (read == 0)
            break;
        if (bytes.size() > most)
            refuseBomb();
    }
    m_unpacked += bytes.size();
    return bytes;
}

} // namespace

std::unique_ptr<ZipFile> openZip(QByteArrayView bytes) {
    return std::make_unique<ZipFileOfLibzip>(bytes);
}

} // namespace palmer
