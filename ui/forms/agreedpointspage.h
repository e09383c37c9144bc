#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/model/selection.h"

#include <QWidget>
#include <vector>

class QLabel;
class QPushButton;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace palmer::ui {

class AgreementEdit;
class Chip;
class DocumentModel;

/// The points to be agreed between supplier/manufacturer and user: each agreed, not agreed, not applicable or
/// not declared, with its text.
class AgreedPointsPage : public QWidget {
    Q_OBJECT

public:
    AgreedPointsPage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    /// Moves the focus to the text of a point, by the id of its finding ("agreedPoints.…").
    bool focusField(const QString &id);

protected:
    void changeEvent(QEvent *event) override;

private:
    struct Row {
        const AgreementPoint *point;
        Chip *letter;
        QLabel *name;
        QToolButton *agreed;
        QToolButton *notAgreed;
        QToolButton *notApplicable;
        QToolButton *notDeclared;
        AgreementEdit *text;
        QPushButton *take; ///< what the conditions say
        QLabel *refusal;   ///< of a text that is too long
    };

    void build(const Edition &edition);
    [[nodiscard]] const AgreedPoint *agreed(const AgreementPoint &point) const;
    void setState(const AgreementPoint &point, std::optional<AgreementState> state);
    [[nodiscard]] bool refuses(const Row &row, const QString &text) const;
    void setText(const AgreementPoint &point, const QString &text);
    void takeFromConditions(const AgreementPoint &point);
    void refresh();

    DocumentModel &m_model;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    const Edition *m_built = nullptr;
    Chip *m_chip;
    QLabel *m_source;
    QScrollArea *m_scroll;
    QVBoxLayout *m_body;
    std::vector<Row> m_rows;
    int m_visit = 0; ///< counts the texts the focus came to
};

} // namespace palmer::ui
