// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "import/profiles.h"

#include "document/savedocument.h"

#include <QTemporaryDir>
#include <QTest>

using namespace palmer;

class ProfilesTest : public QObject {
    Q_OBJECT

private slots:
    void areReadAsTheyWereSaved() {
        const ImportProfiles profiles{{"laser", {{"unit", "um"}, {"delimiter", "tab"}}}, {"version", {}}};
        saveImportProfiles(profiles, path());
        QVERIFY(readImportProfiles(path()) == profiles);
    }

    /// They held guesses that nobody had confirmed: what is a question is asked again.
    void thoseOfEarlierProgramsAnswerNoQuestion() {
        saveBytes(R"({"laser": {"unit": "um", "sign": "actualMinusTarget", "directions": "alternating",
                                "correctionTo20": "not applied", "delimiter": "tab", "plane": "YZ"}})",
                  path());
        const ImportProfiles expected{{"laser", {{"delimiter", "tab"}, {"plane", "YZ"}}}};
        QVERIFY(readImportProfiles(path()) == expected);
    }

    void whatIsNoFileOfProfilesIsRefused() {
        for (const char *text : {"[]", R"({"version": 1})", R"({"version": 1, "profiles": {"a": 1}})",
                                 R"({"version": 1, "profiles": {"a": {"unit": "parsec"}}})"}) {
            saveBytes(text, path());
            QVERIFY_THROWS_EXCEPTION(Error, (void)readImportProfiles(path()));
        }
        QVERIFY(readImportProfiles(path() + ".none").empty());
    }

private:
    [[nodiscard]] QString path() const { return m_folder.filePath("profiles.json"); }

    QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(ProfilesTest)
#include "profiles.moc"
