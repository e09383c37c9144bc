// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/machinetype.h"
#include "ui/qtforward.h"

#include <QDialog>
#include <array>

namespace palmer::ui {

class FigureCard;

/// The type test of the machines of one type, a parameter of an axis at a time: the values of the machines,
/// named, both tolerance limits, quantile plots, normality; saved as a page.
class TypeDialog : public QDialog {
    Q_OBJECT

public:
    /// `tests`: of the axes and parameters to choose from, not empty.
    TypeDialog(std::vector<TypeTest> tests, QWidget *parent);

private:
    void show(int index);
    void save();

    std::vector<TypeTest> m_tests;
    QComboBox *m_parameter;
    FigureCard *m_figure;
    std::array<FigureCard *, 2> m_quantiles; ///< of the values, of their logarithms
    QTextBrowser *m_text;
};

/// Shows them in a dialog of their own, or says that there are none.
void showTypeTests(std::vector<TypeTest> tests, QWidget *parent);

} // namespace palmer::ui
