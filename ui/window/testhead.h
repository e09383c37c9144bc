// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QWidget>

namespace palmer::ui {

/// Header of a test: title, axis and cycle, and the edition it is shown under. Another edition is only a
/// view; a button makes it the edition of the test.
class TestHead : public Translated<QWidget> {
    Q_OBJECT

public:
    explicit TestHead(QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    /// Shows only titles, if a page of the report is in view.
    void showTitle(const QString &title, const QString &subtitle);
    /// Shows only the title, if every row of the page counts.
    void setLow(bool low);

signals:
    void viewChosen(const QString &edition);
    void editionSet(const QString &edition);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void retranslate() final;
    void elide();

    QLabel *m_title;
    QLabel *m_subtitle;
    QLabel *m_editionLabel;
    QPushButton *m_set;
    QComboBox *m_edition;
    QString m_titleText;
    QString m_subtitleText;
};

/// "X axis · linear · 1 800 mm · standard cycle · 12 March 2026".
[[nodiscard]] QString testSummary(const Test &test);

} // namespace palmer::ui
