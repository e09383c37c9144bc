// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/register/testtable.h"

#include <QSortFilterProxyModel>
#include <QTableView>

class QMenu;

namespace palmer::ui {

/// The table of a machine's tests, sorted by any column. Its columns fit its width.
class TestsView : public QTableView {
    Q_OBJECT

public:
    TestsView();

    void setTests(std::vector<ListedTest> tests);
    /// See TestTableModel::setNumbers().
    void setNumbers(std::map<int, int> numbers) { m_tests->setNumbers(std::move(numbers)); }
    void setOtherSeries(std::set<QString> digests) { m_tests->setOtherSeries(std::move(digests)); }
    void setSinceLast(int test, std::shared_ptr<const SinceLast> change) {
        m_tests->setSinceLast(test, std::move(change));
    }
    [[nodiscard]] int count() const { return m_sorted->rowCount(); }
    /// Chosen tests by date and time, valid until the next setTests().
    [[nodiscard]] std::vector<const ListedTest *> chosen() const;
    void choose(const QString &digest);
    /// Offers its columns to sort by in a menu, since the header takes no keys.
    void fillSorting(QMenu &menu);
    void retranslate();

signals:
    void chosenChanged();
    void openAsked(); ///< the chosen test

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void openCurrent();
    void fitColumns();
    [[nodiscard]] int neededWidth(int column);
    void fitResults();
    [[nodiscard]] const ListedTest &testAt(const QModelIndex &index) const;

    TestTableModel *m_tests = new TestTableModel(this);
    QSortFilterProxyModel *m_sorted = new QSortFilterProxyModel(this);
    TestDelegate *m_delegate = new TestDelegate(this);
    std::map<int, int>
        m_contents; ///< px that the contents of a column need, where measured since they changed
};

} // namespace palmer::ui
