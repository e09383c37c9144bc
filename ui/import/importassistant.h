// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "figures/figure.h"
#include "import/importmeasurement.h"
#include "import/profiles.h"
#include "ui/import/rawtextmodel.h"
#include "ui/import/recognisedmodel.h"
#include "ui/model/background.h"
#include "ui/model/selection.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QDialog>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace palmer::ui {

class CircleCanvas;
class ColumnRoles;
class FigureCanvas;
class LineView;
class RemarkList;
class WorkBar;
class ZoomButtons;

/// A measurement file as read; may be made on any thread.
struct MeasurementFile {
    QByteArray bytes;
    QString name; ///< without folder
    Imported imported;
    std::string hash; ///< SHA-256 of the bytes
    TestPointer test; ///< test of `imported`, to be drawn on another thread; null if none
    TextLines lines;  ///< of `imported`
};

/// Throws Error if nothing in the bytes can be shown.
[[nodiscard]] MeasurementFile readMeasurementFile(const QByteArray &bytes, const QString &fileName,
                                                  const ImportOptions &options = {});

/// True if reading would block the window too long and is done on a thread.
[[nodiscard]] bool isLargeFile(qint64 bytes);

/// "Import…": shows the content of a measurement file before it is accepted: the text as read, the column
/// roles, the resulting table and curve, every choice with its origin, the questions and remarks. Changing
/// a choice reads the file again; each question must be answered before the import. A file without a
/// readable measurement is shown with what is missing. Changes no document: the caller adds the data with
/// addTo(). Over 500 lines: text, roles, table, curve, questions and remarks show one reading, which parts
/// of their own would pass back and forth.
class ImportAssistant : public Translated<QDialog> {
    Q_OBJECT

public:
    /// `open`: the open document to add the measurement to; may be null. Throws Error if nothing in the bytes
    /// can be shown.
    ImportAssistant(const QByteArray &bytes, const QString &fileName, const Document *open,
                    QWidget *parent = nullptr);
    ImportAssistant(MeasurementFile file, const Document *open, QWidget *parent = nullptr);

    [[nodiscard]] const Imported &imported() const { return m_file.imported; }
    /// True if the measurement goes into a new document instead of the open one.
    [[nodiscard]] bool wantsNewDocument() const;
    /// Returns at once for the document it was accepted for, as the work was done on accepting.
    void addTo(Document &document) const;

    /// Sets a choice as its box does; empty: as found in the file.
    void choose(const std::string &key, const std::string &value);
    /// Accepts the proposed answers, except to questions about data that were not read.
    void confirmAll();
    /// Replaces the current data; on failure shows a message and changes nothing. Large files are read in the
    /// background with a progress bar; Cancel leaves everything unchanged.
    void takeFile(const QByteArray &bytes, const QString &fileName);
    void pasteText();

    /// Shows how many files follow this one.
    void setFollowing(qsizetype files);

    /// Stores the user's choices under a name, without values from the file itself and unconfirmed guesses.
    /// On failure shows a message and returns false.
    bool saveProfile(const QString &name);

    /// Adds a large measurement to the document in the background and closes when done.
    void accept() override;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    struct Box {
        std::string key;
        QWidget *cell = nullptr;
        QLabel *name = nullptr;
        QLabel *badge = nullptr;
        QComboBox *words = nullptr; ///< null if typed
        QLineEdit *edit = nullptr;
    };

    void makeLayout();
    QWidget *makeMiddle();
    QWidget *makeRemarks();
    void connectAll();
    /// Shows size and hash of the file and how many follow.
    void sayOrigin();
    void useLastProfile();
    void chooseOther();
    void takeTyped();
    void takeOptions(ImportOptions options);
    void read(const QByteArray &bytes, const QString &name, const ImportOptions &options,
              std::function<void(std::variant<MeasurementFile, Error>)> take);
    void settle();
    void cancelReading();
    void takeOther(MeasurementFile file);
    [[nodiscard]] Document destination() const;
    [[nodiscard]] std::function<std::variant<Document, Error>(Document)> taking() const;
    void finish(std::variant<Document, Error> outcome);
    void showEvaluated(const EvaluatedDocument &evaluated, std::optional<CurveFigure> curve);
    void useProfile(const QString &name);
    void fillProfiles(const QString &current);
    void askProfileName();
    void readTableAt(const QModelIndex &place);
    [[nodiscard]] std::vector<ImportChoice> shownChoices() const;
    void makeBoxes();
    void changeBoxes(const std::vector<ImportChoice> &shown);
    [[nodiscard]] Box makeBox(const ImportChoice &choice);
    void fillEditions(QComboBox &editions) const;
    [[nodiscard]] int boxColumns() const;
    void placeBoxes();
    void showChoices();
    /// Shows the value of a choice in its box.
    void showChoice(const Box &box, const QString &value, bool guessed);
    void fillSheets(QComboBox &sheets) const;
    void showLine(std::size_t line);
    void showAnswerOf(const QString &key);
    void showRemarks();
    void showCurve();
    void showSizes();
    // Counts for a measurement's kind.
    [[nodiscard]] static QStringList sizesOf(const PositioningMeasurement &measurement);
    [[nodiscard]] QStringList sizesOf(const CircularMeasurement &measurement) const;
    [[nodiscard]] QStringList sizesOf(const DriftMeasurement &measurement) const;
    [[nodiscard]] QString pointsText() const;
    void showState();
    void refresh();
    void takeRead(MeasurementFile file);
    void refuse(const Error &error, const QString &file);
    void retranslate() final;

    MeasurementFile m_file;
    std::optional<Document> m_document; ///< the open one; may be null
    ImportOptions m_options;
    ImportOptions m_settled; ///< the options that the displayed data were read with
    QString m_settledProfile;
    std::optional<Document> m_taken; ///< the document including the measurement, once accepted
    int m_following = 0;             ///< number of files after this one
    ImportProfiles m_profiles;
    std::optional<QString> m_refusal; ///< why the last choices cannot be used
    Selection m_selection;
    RawTextModel m_raw;
    RecognisedModel m_recognised;
    std::optional<CurveFigure> m_curve; ///< large measurements: thinned to the screen's resolution
    std::vector<Box> m_boxes;

    QLabel *m_title;
    QLabel *m_origin;
    QPushButton *m_other;
    QPushButton *m_paste;
    QGridLayout *m_choices;
    int m_boxColumns = 0;
    QLabel *m_destinationName;
    QComboBox *m_destination;
    QLabel *m_profileName;
    QComboBox *m_profile;
    QLabel *m_rawTitle;
    QLabel *m_rawSize;
    QListView *m_rawView;
    QLabel *m_tableTitle;
    QLabel *m_tableSize;
    ColumnRoles *m_columns;
    QTableView *m_table;
    QLabel *m_curveTitle;
    ZoomButtons *m_zoom;
    QStackedWidget *m_curves;
    FigureCanvas *m_curveCanvas;
    CircleCanvas *m_circleCanvas;
    LineView *m_lineView;
    QLabel *m_noCurve;
    QLabel *m_remarksTitle;
    QPushButton *m_confirmAll;
    RemarkList *m_remarks;
    QScrollArea *m_remarksPlace = nullptr;
    QCheckBox *m_keep;
    QPushButton *m_saveProfile;
    QLabel *m_open;
    QPushButton *m_cancel;
    QPushButton *m_import;
    WorkBar *m_work;
    Background m_reader;
    Background m_drawer; ///< draws the curve of a large measurement
};

} // namespace palmer::ui
