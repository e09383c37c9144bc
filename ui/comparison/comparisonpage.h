// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/comparedtests.h"
#include "report/blocks/report.h"
#include "ui/model/background.h"
#include "ui/model/documentmodel.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QWidget>
#include <optional>

namespace palmer::ui {

class ComparisonSide;
class ElidedBox;
class ElidedLabel;
class RowTable;

/// The page "Comparison" of a test: what has changed from another test of this file (which the test then
/// states, and the report prints) or of another file (for looking only): decision, differing conditions,
/// all parameters with U of the difference. Compares in the background, while in view. Over 500 lines: the
/// sides, the table and the decision follow one pair of tests.
class ComparisonPage : public Translated<QWidget> {
    Q_OBJECT

public:
    explicit ComparisonPage(DocumentModel &model, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    /// A widget next to the page, made by its owner.
    void setSide(ComparisonSide *side) { m_side = side; }
    /// Compares with the tests of another file; on failure shows a message and returns false.
    bool addFile(const QString &path);
    [[nodiscard]] bool isBusy() const { return m_worker.isBusy(); }
    /// The typed tolerance if it cannot be accepted.
    [[nodiscard]] QStringList refusedTexts() const;

protected:
    void showEvent(QShowEvent *event) override;

private:
    /// A test to compare with: of this file, or of another one.
    struct Offer {
        std::shared_ptr<const EvaluatedDocument> evaluated;
        std::size_t test = 0;
        QString file; ///< empty: this one

        [[nodiscard]] PlacedTest placed() const { return {evaluated.get(), test}; }
    };
    struct Result {
        Offer before;
        Offer after;
        TestComparison comparison;
        bool swapped = false;
    };

    void makeBar();
    void fillBox();
    void choose(int row);
    void chooseFile();
    void showRefusal();
    void state();
    void want();
    void present();
    void fillConditions(const PlacedTest &was, const PlacedTest &is);
    void fillParameters(const PlacedTest &was, const PlacedTest &is);
    void copy();
    void retranslate() final;
    [[nodiscard]] QString refusal() const;
    [[nodiscard]] std::optional<double> tolerance() const;
    [[nodiscard]] std::optional<Offer> chosen() const;
    [[nodiscard]] const Test *test() const;

    DocumentModel &m_model;
    std::shared_ptr<const EvaluatedDocument> m_evaluated = std::make_shared<const EvaluatedDocument>();
    std::size_t m_test = 0;
    std::vector<Offer> m_offers;
    QStringList m_choices;               ///< that the box offers
    std::optional<std::size_t> m_ofFile; ///< the offer of another file that is shown
    std::optional<Result> m_result;
    Background m_worker;
    ComparisonSide *m_side = nullptr;

    QWidget *m_bar;
    QLabel *m_label = nullptr;
    ElidedBox *m_other = nullptr;
    QToolButton *m_forwards = nullptr;
    QToolButton *m_backwards = nullptr;
    QLabel *m_toleranceLabel = nullptr;
    QLineEdit *m_tolerance = nullptr;
    ElidedLabel *m_refusal = nullptr; ///< why the tolerance cannot be accepted
    QCheckBox *m_untouched = nullptr;
    QToolButton *m_copy = nullptr;
    QFrame *m_decision;
    QLabel *m_word;
    QLabel *m_counts;
    QLabel *m_main;
    QLabel *m_conditionsTitle;
    RowTable *m_conditions;
    RowTable *m_parameters;
    QLabel *m_reason;
    QLabel *m_note;
};

} // namespace palmer::ui
