// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/autosave.h"

#include "document/recovery.h"
#include "document/savedocument.h"
#include "ui/model/settings.h"

#include <QDir>
#include <QStandardPaths>
#include <QUuid>

namespace palmer::ui {

namespace {

constexpr int delay = 2000; ///< ms

} // namespace

QString Autosave::folder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
           QStringLiteral("/recovery");
}

Autosave::Autosave(DocumentModel &model, QObject *parent)
    : QObject(parent)
    , m_model(model)
    , m_file(folder() + u'/' + QUuid::createUuid().toString(QUuid::WithoutBraces) +
             QStringLiteral(".recovery")) {
    m_timer.setSingleShot(true);
    m_timer.setInterval(delay);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        if (m_model.isModified() && keepsCopies())
            write();
    });
    connect(&m_model, &DocumentModel::changed, this, &Autosave::follow);
    connect(&m_model, &DocumentModel::fileChanged, this, &Autosave::follow);
}

Autosave::~Autosave() {
    discard();
    m_writer.wait();
    m_lock.reset(); // removes its file too
}

void Autosave::follow() {
    if (!m_model.isModified())
        discard();
    else if (!m_timer.isActive())
        m_timer.start(); // not restarted, or continuous typing would delay the copy forever
}

void Autosave::write() {
    m_kept = false;
    if (!m_lock) {
        QDir().mkpath(folder());
        m_lock = std::make_unique<QLockFile>(recoveryLock(m_file));
        m_lock->setStaleLockTime(0);
        m_lock->tryLock(0); // its name is unique; if locking fails, so will writing the copy
    }
    m_writer.cancel();
    m_writer.start(
        [this, document = m_model.document(), path = m_model.path(),
         state = m_fileState](const Background::Job &) -> std::optional<Error> {
            try {
                saveBytes(writeRecovery(*document, {path, QDateTime::currentDateTimeUtc(), state}), m_file);
                m_kept = true;
                return {};
            } catch (const Error &failure) {
                return failure;
            }
        },
        [this, document = m_model.document()](const std::optional<Error> &error) {
            finish(document, error);
        });
}

void Autosave::finish(const DocumentPointer &document, const std::optional<Error> &error) {
    if (!error)
        emit saved(document);
    else if (!m_failing)
        emit failed(*error);
    m_failing = error.has_value();
}

bool Autosave::flush() {
    m_timer.stop();
    m_writer.wait(); // the copy in progress is outdated
    write();
    m_writer.wait();
    return m_kept;
}

void Autosave::discard() {
    m_timer.stop();
    m_writer.cancel();
    if (m_lock) // on the writer's thread, after any write in progress, without waiting
        m_writer.start([file = m_file](const Background::Job &) { QFile::remove(file); }, [] {});
}

} // namespace palmer::ui
