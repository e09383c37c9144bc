// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/model/settings.h"

#include "fulldisk.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

class SettingsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(m_folder.isValid());
        for (const QSettings::Format format : {QSettings::NativeFormat, QSettings::IniFormat})
            QSettings::setPath(format, QSettings::UserScope, m_folder.path());
        QCoreApplication::setOrganizationName("palmer-test");
        QCoreApplication::setApplicationName("settings");
        QSettings former;
        former.setValue("window/language", "fr");
        former.setValue("window/geometry", QByteArray("\x00\xFF\x01", 3));
        former.sync();
        palmer::ui::useSafeSettings();
    }

    void takesOverWhatWasThere() {
        QCOMPARE(QSettings().value("window/language").toString(), "fr");
        QCOMPARE(QSettings().value("window/geometry").toByteArray(), QByteArray("\x00\xFF\x01", 3));
    }

    void keepsEveryKindOfValue() {
        {
            QSettings settings;
            settings.setValue("a/text", "“é” \n");
            settings.setValue("a/bytes", QByteArray("\x00\x80z", 3));
            settings.setValue("a/number", 281);
            settings.setValue("a/yes", true);
            settings.setValue("a/months", QVariantMap{{"maker 17", 6}, {"maker 18", 12}});
            settings.beginWriteArray("list", 2);
            for (int i = 0; i < 2; ++i) {
                settings.setArrayIndex(i);
                settings.setValue("path", QString::number(i));
            }
            settings.endArray();
        }
        const QSettings again(QSettings().fileName(), QSettings().format()); // from the disk
        QCOMPARE(again.value("a/text").toString(), "“é” \n");
        QCOMPARE(again.value("a/bytes").toByteArray(), QByteArray("\x00\x80z", 3));
        QCOMPARE(again.value("a/number").toInt(), 281);
        QVERIFY(again.value("a/yes").toBool());
        QCOMPARE(again.value("a/months").toMap(), (QVariantMap{{"maker 17", 6}, {"maker 18", 12}}));
        QCOMPARE(again.value("list/size").toInt(), 2);
        QCOMPARE(again.value("list/2/path").toString(), "1");
    }

    void aFullDiskLeavesThemAsTheyWere() {
        QSettings settings;
        settings.setValue("recent", QString(2000, 'x'));
        settings.sync();
        QCOMPARE(settings.status(), QSettings::NoError);
        QFile file(settings.fileName());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray before = file.readAll();
        file.close();
        for (rlim_t limit = 0; limit < 2000; limit += 333) {
            {
                const FullDisk full(limit);
                settings.setValue("recent", QString(1990 + static_cast<int>(limit), 'y'));
                settings.sync();
            }
            QCOMPARE(settings.status(), QSettings::AccessError);
            QVERIFY(file.open(QIODevice::ReadOnly));
            QCOMPARE(file.readAll(), before);
            file.close();
        }
        QCOMPARE(QDir(QFileInfo(file).path()).entryList({"settings.json*"}, QDir::Files).size(), 1);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(SettingsTest)
#include "settingstest.moc"
