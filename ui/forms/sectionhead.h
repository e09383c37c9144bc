// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

namespace palmer::ui {

/// Head of a foldable section: title, summary of a folded section in one line, arrow. A click folds and
/// unfolds; screen readers are told the state.
class SectionHead : public QAbstractButton {
    Q_OBJECT

public:
    explicit SectionHead(QWidget *parent = nullptr);

    void setTitle(const QString &title);
    /// `asks`: the summary reports something missing.
    void setSummary(const QString &summary, bool asks);
    void setFolded(bool folded);
    [[nodiscard]] bool isFolded() const { return m_folded; }
    [[nodiscard]] QString summary() const { return m_summary; }

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void retranslate();

    QString m_summary;
    bool m_asks = false;
    bool m_folded = false;
};

} // namespace palmer::ui
