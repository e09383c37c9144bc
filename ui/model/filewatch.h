#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>

namespace palmer::ui {

/// Notices when another program changes the file of a document. What counts is the content: a file that was
/// touched, or written anew with the same bytes, has not changed.
class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(QObject *parent = nullptr);

    /// Takes the file as it is now for known; an empty path watches nothing.
    void watch(const QString &path);

    /// Whether the file is another than the one known, or gone. Looks at the disk.
    [[nodiscard]] bool isChanged();

signals:
    /// Told once for every state of the file that is not known.
    void changed();

private:
    struct State {
        bool exists = false;
        qint64 size = 0;
        QDateTime modified;
        QByteArray hash;
    };
    [[nodiscard]] State stateOf(bool withHash) const;
    void look();

    QFileSystemWatcher m_watcher;
    QString m_path;
    State m_known;
    State m_told; ///< the state told last
};

} // namespace palmer::ui
