// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/forms/refusedfields.h"
#include "ui/model/selection.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QWidget>
#include <vector>

namespace palmer::ui {

class AgreementEdit;
class Chip;
class LinkChip;
class DocumentModel;

/// The points to be agreed between supplier/manufacturer and user: each agreed, not agreed, not applicable or
/// not declared, with its text.
class AgreedPointsPage : public Translated<QWidget, QEvent::FontChange> {
    Q_OBJECT

public:
    AgreedPointsPage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    /// Focuses the text of a point by the ID of its finding ("agreedPoints.…").
    bool focusField(const QString &id);
    /// A point with what is said of it, as the search shows it; `id` is that of its finding.
    struct Found {
        QString id;
        QString name;
        QString value;
        bool isMissing = false;
    };
    [[nodiscard]] std::vector<Found> found() const;
    /// Numbers typed here, for any test, that cannot be accepted.
    [[nodiscard]] QStringList refusedTexts() const;

signals:
    /// The chip was clicked: to the next missing statement.
    void nextWanted();

private:
    struct Row {
        const AgreementPoint *point = nullptr;
        QWidget *area = nullptr;
        Chip *letter = nullptr;
        QLabel *name = nullptr;
        QToolButton *agreed = nullptr;
        QToolButton *notAgreed = nullptr;
        QToolButton *notApplicable = nullptr;
        QToolButton *notDeclared = nullptr;
        AgreementEdit *text = nullptr;
        QPushButton *take = nullptr; ///< copies the statement of the conditions
        QLabel *refusal = nullptr;   ///< shown for a text that is too long
        Field *value = nullptr;      ///< the agreed number; null for points agreed only in words
    };

    [[nodiscard]] static QString idOf(const Row &row);
    void build(const Edition &edition, const Test &test);
    void addRow(const AgreementPoint &point, const Test &test);
    [[nodiscard]] QHBoxLayout *makeStates(const Row &row);
    [[nodiscard]] const AgreedPoint *agreed(const AgreementPoint &point) const;
    void setState(const AgreementPoint &point, std::optional<AgreementState> state);
    Field *makeValue(const AgreementPoint &point, Quantity quantity, QWidget *parent);
    [[nodiscard]] static bool refuses(const Row &row, const QString &text);
    void setText(const AgreementPoint &point, const QString &text);
    void copyFromConditions(const AgreementPoint &point);
    void refresh();
    void retranslate() final { refresh(); }
    static void refreshLetter(const Row &row, bool isCounted, bool settled, bool declared);
    void refreshRow(const Row &row, const Test &test, const AgreedPoint *agreed, bool settled);

    DocumentModel &m_model;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    const Edition *m_built = nullptr;
    bool m_builtRotary = false;
    LinkChip *m_chip;
    QLabel *m_source;
    QScrollArea *m_scroll;
    QVBoxLayout *m_body;
    QPushButton *m_others = nullptr; ///< shows the points that do not apply
    bool m_showsAll = false;
    RefusedFields m_refused;
    QString m_of; ///< ID of the test in the fields
    std::vector<Row> m_rows;
    int m_visit = 0; ///< counts how often a text was focused
};

} // namespace palmer::ui
