// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/comparison.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QDialog>
#include <vector>

namespace palmer::ui {

class ComparisonView;

/// "Compare…": the test in view under several editions, with the reason of each difference, and next to other
/// tests of this or other files, e.g. as found and as left, or this year and the last.
class CompareDialog : public Translated<QDialog> {
    Q_OBJECT

public:
    CompareDialog(const EvaluatedDocument &evaluated, std::size_t test, QWidget *parent = nullptr);

    /// Adds the tests of another file; on failure shows a message and returns false.
    bool addFile(const QString &path);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Offer {
        std::shared_ptr<const EvaluatedDocument> evaluated;
        std::size_t test = 0;
        QString name;
        bool isChosen = false;
    };

    void offer(const std::shared_ptr<const EvaluatedDocument> &evaluated, const QString &file);
    void fillLists();
    void showEditions();
    void showTests();
    void chooseFile();
    void copy();
    void retranslate() final;

    std::shared_ptr<const EvaluatedDocument> m_evaluated;
    std::size_t m_test;
    std::vector<std::pair<std::string, bool>> m_editions; ///< edition, and whether it is shown
    std::vector<Offer> m_offers;                          ///< the first is the test in view
    std::vector<std::pair<QString, Message>> m_guesses;   ///< file, and an assumption of its import
    ResultComparison m_ofEditions;
    ResultComparison m_ofTests;

    QTabWidget *m_tabs;
    QListWidget *m_editionList;
    QTableWidget *m_editionTable;
    QLabel *m_editionNotes;
    QListWidget *m_testList;
    ComparisonView *m_view;
    QTableWidget *m_testTable;
    QLabel *m_testNotes;
    QPushButton *m_addFile;
    QPushButton *m_copy;
    QPushButton *m_close;
};

} // namespace palmer::ui
