// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/circles/arcsmodel.h"
#include "ui/circles/pointsmodel.h"
#include "ui/forms/field.h"
#include "ui/forms/refusedfields.h"
#include "ui/model/documentmodel.h"
#include "ui/model/selection.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QPersistentModelIndex>
#include <QWidget>
#include <functional>
#include <vector>

namespace palmer::ui {

class ArcCurvesView;

/// The page "Readings" of a circular test: parameters, arcs with their evaluated range, the unwrapped curve
/// and the points. Arcs are added as tables and deleted; parameters, sense, order and evaluated range are
/// edited here, each as one undo step. Over 500 lines: all its parts follow one selected arc.
class CirclesPage : public Translated<QWidget, QEvent::FontChange> {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(CirclesPage)

public:
    CirclesPage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);
    ~CirclesPage() override; ///< destroys the tables before their models

    /// Shows a circular test; empty for any other.
    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);

    /// Actions on arcs, for the window's menus. Shortcuts work on the page.
    [[nodiscard]] const QList<QAction *> &testActions() const { return m_testActions; }

    /// Texts typed here, for any test, that cannot be accepted.
    [[nodiscard]] QStringList refusedTexts() const;

    /// Makes a point current and focuses it in its table, if that is visible.
    void showPoint(const ReadingPlace &point);
    /// Undoes the last refused typing of a point. False if there is none.
    bool undoRefused();
    /// Asks for the points of an arc, starting with that text, and adds those accepted.
    void askForArc(const QString &text);
    /// Appends arcs as one undo step.
    void addArcs(const std::vector<Arc> &arcs);

signals:
    void importAsked();

protected:
    void resizeEvent(QResizeEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Labelled {
        QLabel *label = nullptr;
        const char *source = nullptr;
        QWidget *field = nullptr;
    };

    void makeParameters(QVBoxLayout &rows);
    [[nodiscard]] QHBoxLayout *makeRangeRow();
    void makeArcButtons();
    void nameRange();
    void makeTables();
    void makeActions();
    void deleteArc();
    void typePoint(const QModelIndex &index, const QString &text);
    QComboBox *addChoice(QHBoxLayout &row, int share, const char *name, const char *label);
    Field *makeNumber(const char *name);
    void readPositive(Field *field, Quantity quantity, bool needed);
    [[nodiscard]] Field::Reading readEnd(const Field *end, const QString &typed) const;
    void typeRange(const Field *end);
    void enableActions();
    void showReason();
    void leaveFields(const std::vector<Field *> &fields);
    [[nodiscard]] QString shownArc() const;
    [[nodiscard]] QString stepOf(const Field *field) const; ///< merge key of undo steps
    QWidget *labelled(QHBoxLayout &row, int share, const char *label, QWidget *field);
    QToolButton *addUnit(QButtonGroup &group, const char *segment, const char *name, PointUnit unit);

    void refresh();
    void fillParameters(const CircularMeasurement &shown);
    void fillRange();
    void fitColumns();
    void showParts();
    void chooseArc(int row);
    void setPlane();
    void hover(const QModelIndex &index);
    void showHovered();
    void showCurrent();
    void retranslate() final;
    [[nodiscard]] const CircularMeasurement *measurement() const;
    /// Changes the test in view; `name` is a source text of the context "edits".
    void edit(const char *name, const std::function<void(CircularMeasurement &)> &change,
              const QString &mergeKey = {});
    void setRange(std::size_t arc, std::optional<Interval> range, const QString &mergeKey = {});

    DocumentModel &m_model;
    Selection &m_selection;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    std::size_t m_arc = 0;          ///< the current one
    std::string m_shownId;          ///< ID of the test
    int m_visit = 0;                ///< counts how often a number field was focused
    std::vector<Field *> m_numbers; ///< number fields, and the text field of an arc
    RefusedFields m_refused;
    QPersistentModelIndex m_refusedPoint; ///< refused since the last undo step
    QString m_pointReason;                ///< why the last typed point was refused
    std::string m_curvesOf;               ///< ID of the test in the curves
    bool m_filling = false;
    ArcsModel m_arcsModel;
    PointsModel m_pointsModel;

    std::vector<Labelled> m_labels;
    QComboBox *m_plane = nullptr;
    Field *m_radius = nullptr;
    Field *m_feed = nullptr;
    QComboBox *m_source = nullptr;
    QComboBox *m_circle = nullptr;
    QComboBox *m_centring = nullptr;
    QComboBox *m_angle = nullptr;
    QTableView *m_arcs = nullptr;
    QLabel *m_rangeLabel = nullptr;
    Field *m_from = nullptr;
    Field *m_to = nullptr;
    Field *m_cutOff = nullptr; ///< the part outside the range
    QPushButton *m_whole = nullptr;
    QPushButton *m_reverse = nullptr;
    QToolButton *m_earlier = nullptr;
    QToolButton *m_later = nullptr;
    QToolButton *m_delete = nullptr;
    QToolButton *m_newArc = nullptr;
    QWidget *m_emptyPlace = nullptr; ///< shown in place of the points
    QLabel *m_empty = nullptr;
    QPushButton *m_import = nullptr;
    QList<QAction *> m_testActions;
    QAction *m_newArcAction = nullptr;
    QAction *m_pasteArcAction = nullptr;
    QAction *m_deleteArcAction = nullptr;
    ArcCurvesView *m_curves = nullptr;
    QTableView *m_points = nullptr;
    QLabel *m_reason = nullptr;
    QToolButton *m_deviations = nullptr;
    QToolButton *m_coordinates = nullptr;
    QToolButton *m_lengths = nullptr;
    bool m_following = false; ///< the selection is moving the current cell
};

} // namespace palmer::ui
