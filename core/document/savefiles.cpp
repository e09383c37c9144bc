// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/savefiles.h"

#include "system/filename.h"
#include "system/files.h"

#include <QDir>
#include <QFileInfo>
#include <QStorageInfo>
#include <memory>
#include <utility>

namespace palmer {

namespace {

[[noreturn]] void refuseFiles(Text text) {
    throw Error(Error::Kind::unwritable, {text, {}, {}});
}

// The system's message may be in another language, so determine the cause here.
[[noreturn]] void refuseSaving(const QString &path, qint64 size) {
    const QFileInfo info(path);
    const QStorageInfo disk(info.absolutePath());
    if (disk.isValid() && disk.isReadOnly())
        refuseFiles(REPORT_TEXT("report", "the disk is read-only; save in a folder of another disk"));
    if (disk.isValid() && disk.bytesAvailable() < size)
        refuseFiles(REPORT_TEXT("report",
                                "the disk is full; what was there before is unchanged: free some space or "
                                "save on another disk"));
    refuseFiles(REPORT_TEXT(
        "report", "the file could not be saved, for want of permission or space; what was there before "
                  "is unchanged: save it under another name or in another folder"));
}

[[noreturn]] void refuseDevice(DeviceFault fault) {
    if (fault == DeviceFault::full)
        refuseFiles(REPORT_TEXT("report", "the device is full; save to a file or to another device"));
    if (fault == DeviceFault::unread)
        refuseFiles(
            REPORT_TEXT("report", "nobody reads from this pipe; start its reader first, or save to a file"));
    refuseFiles(REPORT_TEXT(
        "report", "the device could not be written, for want of permission or because it is none that "
                  "takes a file; save to a file"));
}

/// Checks what can be seen without writing.
void requirePlace(const QString &path) {
    if (!isUtf8FileName(path))
        refuseFiles(
            REPORT_TEXT("report", "a name to save to has to be UTF-8, and this one is not; choose another"));
    const QFileInfo info(path);
    if (info.isDir())
        refuseFiles(REPORT_TEXT("report", "this is a folder; expected the name of a file to save to"));
    if (!info.absoluteDir().exists())
        refuseFiles(REPORT_TEXT("report", "the folder does not exist; create it or save in another folder"));
}

/// True for a device, which renaming would replace.
bool isDevice(const QString &path) {
    const QFileInfo info(path);
    return info.exists() && !info.isFile();
}

/// A file to save, written and on the disk.
class Staged {
public:
    explicit Staged(const FileToSave &file)
        : m_source(file)
        , m_staged(stageFile(file.bytes, file.path)) {
        if (!m_staged->isComplete())
            refuseSaving(m_source.path, m_source.bytes.size());
    }

    /// If further files are to be renamed, keeps the existing file, if the file system exchanges names.
    void rename(bool keepOld) {
        if (!m_staged->takeName(keepOld))
            refuseSaving(m_source.path, m_source.bytes.size());
    }
    void restore() { m_staged->restore(); }

    [[nodiscard]] const QString &path() const { return m_source.path; }

private:
    const FileToSave &m_source;
    std::unique_ptr<StagedFile> m_staged;
};

/// Runs `work` for one file and adds its name to errors.
void forFile(const QString &path, auto &&work) {
    try {
        work();
    } catch (const Error &error) {
        throw UnsavedFile(error, path);
    }
}

void renameAll(std::vector<std::unique_ptr<Staged>> &staged) {
    for (std::size_t i = 0; i < staged.size(); ++i) {
        const bool last = i + 1 == staged.size();
        try {
            forFile(staged[i]->path(), [&] { staged[i]->rename(!last); });
        } catch (const UnsavedFile &) {
            for (std::size_t done = 0; done < i; ++done)
                staged[done]->restore();
            throw;
        }
    }
    for (const auto &file : staged)
        syncFolderOf(file->path());
}

} // namespace

void saveFiles(const std::vector<FileToSave> &files, UnreadPipe unread) {
    for (const FileToSave &file : files)
        forFile(file.path, [&] { requirePlace(file.path); });
    std::vector<std::unique_ptr<Staged>> staged;
    for (const FileToSave &file : files) {
        if (!isDevice(file.path))
            forFile(file.path, [&] { staged.push_back(std::make_unique<Staged>(file)); });
    }
    for (const FileToSave &file : files) {
        if (isDevice(file.path))
            forFile(file.path, [&] {
                const DeviceFault fault = writeDevice(file.bytes, file.path, unread == UnreadPipe::awaited);
                if (fault != DeviceFault::none)
                    refuseDevice(fault);
            });
    }
    renameAll(staged);
}

} // namespace palmer
