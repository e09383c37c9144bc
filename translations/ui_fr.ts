<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>edits</name>
    <message>
        <source>set the edition of the test</source>
        <translation>définir l’édition de l’essai</translation>
    </message>
    <message>
        <source>choose what the report has</source>
        <translation>choisir ce que contient le rapport</translation>
    </message>
</context>
<context>
    <name>examples</name>
    <message>
        <source>X axis, published example</source>
        <translation>Axe X, exemple publié</translation>
    </message>
    <message>
        <source>Long axis, with its zone</source>
        <translation>Axe long, avec sa zone</translation>
    </message>
    <message>
        <source>Z axis, from one direction</source>
        <translation>Axe Z, dans un seul sens</translation>
    </message>
    <message>
        <source>Rotary table C, 360°</source>
        <translation>Table rotative C, 360°</translation>
    </message>
    <message>
        <source>%1 · %2 targets, %3 runs</source>
        <translation>%1 · %2 points, %3 passes</translation>
    </message>
</context>
<context>
    <name>palmer::ui::AgreedPointsPage</name>
    <message>
        <source>settled</source>
        <translation>réglé</translation>
    </message>
    <message>
        <source>not agreed</source>
        <translation>non convenu</translation>
    </message>
    <message>
        <source>Agreed</source>
        <translation>Convenu</translation>
    </message>
    <message>
        <source>Not agreed</source>
        <translation>Non convenu</translation>
    </message>
    <message>
        <source>Not applicable</source>
        <translation>Sans objet</translation>
    </message>
    <message>
        <source>text of the agreement</source>
        <translation>texte de l’accord</translation>
    </message>
    <message>
        <source>%1 of %2 points not agreed</source>
        <translation>%1 points sur %2 non convenus</translation>
    </message>
    <message>
        <source>%1, clause %2</source>
        <translation>%1, article %2</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ConditionsPage</name>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>chosen freely</source>
        <translation>choisis librement</translation>
    </message>
    <message>
        <source>faces of the polygon</source>
        <translation>faces du polygone</translation>
    </message>
    <message>
        <source>given by the device</source>
        <translation>imposés par l’appareil</translation>
    </message>
    <message>
        <source>not applied</source>
        <translation>non appliquée</translation>
    </message>
    <message>
        <source>by the instrument</source>
        <translation>par l’instrument</translation>
    </message>
    <message>
        <source>applied here</source>
        <translation>appliquée ici</translation>
    </message>
    <message>
        <source>agreed or the maker's procedure</source>
        <translation>procédure convenue ou du constructeur</translation>
    </message>
    <message>
        <source>dry run</source>
        <translation>essai à blanc préalable</translation>
    </message>
    <message>
        <source>set-up movements only</source>
        <translation>mouvements de réglage seulement</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>vitesse rapide</translation>
    </message>
    <message>
        <source>Temperatures</source>
        <translation>Températures</translation>
    </message>
    <message>
        <source>Air, start</source>
        <translation>Air, début</translation>
    </message>
    <message>
        <source>Air, end</source>
        <translation>Air, fin</translation>
    </message>
    <message>
        <source>Position of the sensor</source>
        <translation>Position du capteur</translation>
    </message>
    <message>
        <source>Correction to 20 °C</source>
        <translation>Correction à 20 °C</translation>
    </message>
    <message>
        <source>Machine, start</source>
        <translation>Machine, début</translation>
    </message>
    <message>
        <source>Machine, end</source>
        <translation>Machine, fin</translation>
    </message>
    <message>
        <source>Expansion α</source>
        <translation>Dilatation α</translation>
    </message>
    <message>
        <source>Instrument, start</source>
        <translation>Instrument, début</translation>
    </message>
    <message>
        <source>Instrument, end</source>
        <translation>Instrument, fin</translation>
    </message>
    <message>
        <source>Air pressure</source>
        <translation>Pression de l’air</translation>
    </message>
    <message>
        <source>Relative humidity</source>
        <translation>Humidité relative</translation>
    </message>
    <message>
        <source>Temperature gradient</source>
        <translation>Gradient de température</translation>
    </message>
    <message>
        <source>Cycle and load</source>
        <translation>Cycle et charge</translation>
    </message>
    <message>
        <source>Feed rate</source>
        <translation>Vitesse d’avance</translation>
    </message>
    <message>
        <source>Dwell at the target</source>
        <translation>Temps d’arrêt au point</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>Warm-up</source>
        <translation>Mise en température</translation>
    </message>
    <message>
        <source>Active compensation</source>
        <translation>Compensation active</translation>
    </message>
    <message>
        <source>Complete, in working order</source>
        <translation>Complète, en état de marche</translation>
    </message>
    <message>
        <source>Levelled and aligned</source>
        <translation>Mise à niveau et alignée</translation>
    </message>
    <message>
        <source>Unloaded</source>
        <translation>À vide</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positions</translation>
    </message>
    <message>
        <source>Position of the instrument</source>
        <translation>Position de l’instrument</translation>
    </message>
    <message>
        <source>Axes not under test</source>
        <translation>Axes non soumis à l’essai</translation>
    </message>
    <message>
        <source>Offset to tool, X</source>
        <translation>Décalage outil, X</translation>
    </message>
    <message>
        <source>Offset to tool, Y</source>
        <translation>Décalage outil, Y</translation>
    </message>
    <message>
        <source>Offset to tool, Z</source>
        <translation>Décalage outil, Z</translation>
    </message>
    <message>
        <source>Offset to workpiece, X</source>
        <translation>Décalage pièce, X</translation>
    </message>
    <message>
        <source>Offset to workpiece, Y</source>
        <translation>Décalage pièce, Y</translation>
    </message>
    <message>
        <source>Offset to workpiece, Z</source>
        <translation>Décalage pièce, Z</translation>
    </message>
    <message>
        <source>Test and axis</source>
        <translation>Essai et axe</translation>
    </message>
    <message>
        <source>Date of test</source>
        <translation>Date de l’essai</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Axis travel</source>
        <translation>Longueur d’axe</translation>
    </message>
    <message>
        <source>Measuring system of the axis</source>
        <translation>Système de mesure de l’axe</translation>
    </message>
    <message>
        <source>Choice of targets</source>
        <translation>Choix des points visés</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ExplanationCard</name>
    <message>
        <source>Explanation of %1</source>
        <translation>Explication de %1</translation>
    </message>
    <message>
        <source>per target, %1</source>
        <translation>par point, %1</translation>
    </message>
    <message>
        <source>Esc closes · ↑↓ next result</source>
        <translation>Échap ferme · ↑↓ résultat suivant</translation>
    </message>
    <message>
        <source>Copy the explanation as text</source>
        <translation>Copier l’explication en texte</translation>
    </message>
    <message>
        <source>Close the explanation (Esc)</source>
        <translation>Fermer l’explication (Échap)</translation>
    </message>
    <message>
        <source>Close the explanation</source>
        <translation>Fermer l’explication</translation>
    </message>
</context>
<context>
    <name>palmer::ui::Field</name>
    <message>
        <source>required</source>
        <translation>requis</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>required, not stated</source>
        <translation>requis, non indiqué</translation>
    </message>
</context>
<context>
    <name>palmer::ui::FigureView</name>
    <message>
        <source>band ±%1s</source>
        <translation>bande ±%1s</translation>
    </message>
    <message>
        <source>PDF, vectors (*.pdf)</source>
        <translation>PDF, vectoriel (*.pdf)</translation>
    </message>
    <message>
        <source>SVG, vectors (*.svg)</source>
        <translation>SVG, vectoriel (*.svg)</translation>
    </message>
    <message>
        <source>PNG, picture (*.png)</source>
        <translation>PNG, image (*.png)</translation>
    </message>
    <message>
        <source>Save figure</source>
        <translation>Enregistrer la figure</translation>
    </message>
    <message>
        <source>The figure could not be written to %1. Choose another folder or file.</source>
        <translation>La figure n’a pas pu être écrite dans %1. Choisissez un autre dossier ou un autre fichier.</translation>
    </message>
    <message>
        <source>Show single readings</source>
        <translation>Afficher les relevés</translation>
    </message>
    <message>
        <source>Show the whole figure</source>
        <translation>Afficher la figure entière</translation>
    </message>
    <message>
        <source>Copy the figure</source>
        <translation>Copier la figure</translation>
    </message>
    <message>
        <source>Save the figure as PDF, SVG or PNG</source>
        <translation>Enregistrer la figure en PDF, SVG ou PNG</translation>
    </message>
    <message>
        <source>Open the figure in a window of its own</source>
        <translation>Ouvrir la figure dans sa propre fenêtre</translation>
    </message>
    <message>
        <source>Maximise the figure</source>
        <translation>Agrandir la figure</translation>
    </message>
    <message>
        <source>Plus and minus zoom, arrows move, 0 shows the whole; the wheel zooms with Ctrl or after a click</source>
        <translation>Plus et moins agrandissent et réduisent, les flèches déplacent, 0 montre tout ; la molette agrandit avec Ctrl ou après un clic</translation>
    </message>
</context>
<context>
    <name>palmer::ui::FindingsModel</name>
    <message>
        <source>Identification</source>
        <translation>Identification</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation>Instruments</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Relevés</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Conditions</translation>
    </message>
    <message>
        <source>Agreed points</source>
        <translation>Points convenus</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Required</source>
        <translation>Requis</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) not agreed</source>
        <translation>
            <numerusform>%n point non convenu</numerusform><numerusform>%n points non convenus</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n required statement(s) missing</source>
        <translation>
            <numerusform>%n information requise manque</numerusform><numerusform>%n informations requises manquent</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s)</source>
        <translation>
            <numerusform>%n constat</numerusform><numerusform>%n constats</numerusform></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>page: what is found there</comment>
        <translation>%1 : %2</translation>
    </message>
    <message numerus="yes">
        <source>%n requirement(s) not met</source>
        <translation>
            <numerusform>%n exigence non tenue</numerusform><numerusform>%n exigences non tenues</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n avertissement</numerusform><numerusform>%n avertissements</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n note</numerusform><numerusform>%n notes</numerusform></translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Not agreed: %1</source>
        <translation>Non convenu : %1</translation>
    </message>
</context>
<context>
    <name>palmer::ui::FindingsPanel</name>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Show the findings</source>
        <translation>Afficher les constats</translation>
    </message>
    <message>
        <source>Fold the findings away</source>
        <translation>Replier les constats</translation>
    </message>
</context>
<context>
    <name>palmer::ui::Form</name>
    <message numerus="yes">
        <source>%n required statement(s) missing</source>
        <translation>
            <numerusform>%n information requise manque</numerusform><numerusform>%n informations requises manquent</numerusform></translation>
    </message>
</context>
<context>
    <name>palmer::ui::IdentificationPage</name>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>Revision</source>
        <translation>Révision</translation>
    </message>
    <message>
        <source>Replaces</source>
        <translation>Remplace</translation>
    </message>
    <message>
        <source>Date of issue</source>
        <translation>Date d’émission</translation>
    </message>
    <message>
        <source>Performed from</source>
        <translation>Réalisé du</translation>
    </message>
    <message>
        <source>to</source>
        <translation>au</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lieu</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>Procédure</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>Laboratoire</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Accreditation</source>
        <translation>Accréditation</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Authorised by</source>
        <translation>Autorisé par</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Fonction</translation>
    </message>
    <message>
        <source>Customer and supplier</source>
        <translation>Client et fournisseur</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Client</translation>
    </message>
    <message>
        <source>Address of the customer</source>
        <translation>Adresse du client</translation>
    </message>
    <message>
        <source>Supplier</source>
        <translation>Fournisseur</translation>
    </message>
    <message>
        <source>Address of the supplier</source>
        <translation>Adresse du fournisseur</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>Adjustments made</source>
        <translation>Réglages effectués</translation>
    </message>
</context>
<context>
    <name>palmer::ui::InstrumentsPage</name>
    <message>
        <source>Instrument</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Désignation</translation>
    </message>
    <message>
        <source>Short name</source>
        <translation>Nom court</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Constructeur</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numéro de série</translation>
    </message>
    <message>
        <source>Calibration certificate</source>
        <translation>Certificat d’étalonnage</translation>
    </message>
    <message>
        <source>Calibrated by</source>
        <translation>Étalonné par</translation>
    </message>
    <message>
        <source>Calibrated on</source>
        <translation>Étalonné le</translation>
    </message>
    <message>
        <source>Calibration due</source>
        <translation>Prochain étalonnage</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
</context>
<context>
    <name>palmer::ui::LanguageSwitch</name>
    <message>
        <source>Language of the window; the report has its own</source>
        <translation>Langue de la fenêtre ; le rapport a la sienne</translation>
    </message>
</context>
<context>
    <name>palmer::ui::LimitsPage</name>
    <message>
        <source>simple acceptance</source>
        <translation>acceptation simple</translation>
    </message>
    <message>
        <source>ISO 14253-1: conformity is to be proven</source>
        <translation>ISO 14253-1 : conformité à prouver</translation>
    </message>
    <message>
        <source>non-conformity is to be proven</source>
        <translation>non-conformité à prouver</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>Règle de décision</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Règle</translation>
    </message>
    <message>
        <source>Guard band, times U</source>
        <translation>Bande de garde, fois U</translation>
    </message>
    <message>
        <source>Agreed limits</source>
        <translation>Limites convenues</translation>
    </message>
    <message>
        <source>Limit of %1</source>
        <translation>Limite de %1</translation>
    </message>
    <message>
        <source>Agreed for edition</source>
        <translation>Convenue pour l’édition</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
</context>
<context>
    <name>palmer::ui::MachinePage</name>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Constructeur</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numéro de série</translation>
    </message>
    <message>
        <source>Year of construction</source>
        <translation>Année de construction</translation>
    </message>
    <message>
        <source>Numerical control</source>
        <translation>Commande numérique</translation>
    </message>
    <message>
        <source>Location</source>
        <translation>Emplacement</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>État</translation>
    </message>
</context>
<context>
    <name>palmer::ui::MainWindow</name>
    <message>
        <source>Open a test file</source>
        <translation>Ouvrir un fichier d’essais</translation>
    </message>
    <message>
        <source>Test files (*.palmer)</source>
        <translation>Fichiers d’essais (*.palmer)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1 cannot be opened</source>
        <translation>%1 ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Lecture de %1…</translation>
    </message>
    <message>
        <source>Place: %1</source>
        <translation>Emplacement : %1</translation>
    </message>
    <message>
        <source>Save the test file</source>
        <translation>Enregistrer le fichier d’essais</translation>
    </message>
    <message>
        <source>%1 cannot be saved</source>
        <translation>%1 ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Save the changes before closing?</source>
        <translation>Enregistrer les modifications avant de fermer ?</translation>
    </message>
    <message>
        <source>Otherwise the changes since the last saving are lost.</source>
        <translation>Sinon, les modifications depuis le dernier enregistrement sont perdues.</translation>
    </message>
    <message>
        <source>No file yet</source>
        <translation>Aucun fichier pour l’instant</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler : %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir : %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Calcul en cours…</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modifié</translation>
    </message>
    <message>
        <source>Saved at %1</source>
        <translation>Enregistré à %1</translation>
    </message>
    <message>
        <source>Example</source>
        <translation>Exemple</translation>
    </message>
    <message>
        <source>About Palmer</source>
        <translation>À propos de Palmer</translation>
    </message>
    <message>
        <source>Evaluates tests of machine tools after ISO 230-2 and ISO 230-4 and prints the report. Free software under the GNU General Public License, version 3 or later; without any warranty.</source>
        <translation>Évalue les essais de machines-outils selon l’ISO 230-2 et l’ISO 230-4 et imprime le rapport. Logiciel libre sous licence publique générale GNU, version 3 ou ultérieure ; sans aucune garantie.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Édition</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>E&amp;ssai</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Ai&amp;de</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>E&amp;xamples</source>
        <translation>E&amp;xemples</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>&amp;New window</source>
        <translation>&amp;Nouvelle fenêtre</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Previous test</source>
        <translation>Essai &amp;précédent</translation>
    </message>
    <message>
        <source>&amp;Next test</source>
        <translation>Essai &amp;suivant</translation>
    </message>
    <message>
        <source>&amp;Set as edition of the test</source>
        <translation>&amp;Définir comme édition de l’essai</translation>
    </message>
    <message>
        <source>&amp;Back to the edition of the test</source>
        <translation>&amp;Revenir à l’édition de l’essai</translation>
    </message>
    <message>
        <source>&amp;Readings</source>
        <translation>&amp;Relevés</translation>
    </message>
    <message>
        <source>&amp;Conditions</source>
        <translation>&amp;Conditions</translation>
    </message>
    <message>
        <source>&amp;Agreed points</source>
        <translation>&amp;Points convenus</translation>
    </message>
    <message>
        <source>&amp;Limits</source>
        <translation>&amp;Limites</translation>
    </message>
    <message>
        <source>&amp;Next missing statement</source>
        <translation>Information manquante &amp;suivante</translation>
    </message>
    <message>
        <source>&amp;Previous missing statement</source>
        <translation>Information manquante pr&amp;écédente</translation>
    </message>
    <message>
        <source>&amp;Maximise the figure</source>
        <translation>A&amp;grandir la figure</translation>
    </message>
    <message>
        <source>&amp;About Palmer</source>
        <translation>À &amp;propos de Palmer</translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation>À propos de &amp;Qt</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Menus</source>
        <translation>Menus</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Re&amp;port…</source>
        <translation>Ra&amp;pport…</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Rapport…</translation>
    </message>
</context>
<context>
    <name>palmer::ui::NavigationList</name>
    <message>
        <source>Pages of the report, tests</source>
        <translation>Pages du rapport, essais</translation>
    </message>
</context>
<context>
    <name>palmer::ui::NavigationModel</name>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Identification</source>
        <translation>Identification</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation>Instruments</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>unfinished</source>
        <translation>en cours</translation>
    </message>
    <message numerus="yes">
        <source>%n required statement(s) missing</source>
        <translation>
            <numerusform>%n information requise manque</numerusform>
            <numerusform>%n informations requises manquent</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palmer::ui::ReadingsModel</name>
    <message>
        <source>Number of the target</source>
        <translation>Numéro du point visé</translation>
    </message>
    <message>
        <source>Target position</source>
        <translation>Point visé</translation>
    </message>
    <message>
        <source>Run %1 %2</source>
        <translation>Passe %1 %2</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Passe %1</translation>
    </message>
    <message>
        <source>Runs %1</source>
        <translation>Passes %1</translation>
    </message>
    <message>
        <source>Computed, %1</source>
        <translation>Calculé, %1</translation>
    </message>
    <message>
        <source>Set aside, without a reason</source>
        <translation>Écarté, sans motif</translation>
    </message>
    <message>
        <source>Set aside: %1</source>
        <translation>Écarté : %1</translation>
    </message>
    <message>
        <source>target %1, %2</source>
        <translation>point visé %1, %2</translation>
    </message>
    <message>
        <source>no reading</source>
        <translation>pas de relevé</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ReadingsPage</name>
    <message>
        <source>Deviations ″</source>
        <translation>Écarts ″</translation>
    </message>
    <message>
        <source>Deviations µm</source>
        <translation>Écarts µm</translation>
    </message>
    <message>
        <source>Positions °</source>
        <translation>Positions °</translation>
    </message>
    <message>
        <source>Positions mm</source>
        <translation>Positions mm</translation>
    </message>
    <message>
        <source>By run</source>
        <translation>Par passe</translation>
    </message>
    <message>
        <source>By direction</source>
        <translation>Par sens</translation>
    </message>
    <message>
        <source>Show deviations from the target positions</source>
        <translation>Afficher les écarts aux points visés</translation>
    </message>
    <message>
        <source>Show actual positions; the data stay as they are</source>
        <translation>Afficher les positions réelles ; les données restent telles quelles</translation>
    </message>
    <message>
        <source>Runs side by side, both directions of a run together</source>
        <translation>Passes côte à côte, les deux sens d’une passe ensemble</translation>
    </message>
    <message>
        <source>All runs of one direction side by side</source>
        <translation>Toutes les passes d’un sens côte à côte</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Relevés</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ReportDialog</name>
    <message>
        <source>Values per target</source>
        <translation>Valeurs par point visé</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Relevés</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Signatures</source>
        <translation>Signatures</translation>
    </message>
    <message>
        <source>Single readings in the figure</source>
        <translation>Relevés dans la figure</translation>
    </message>
    <message>
        <source>Mean repeatability (1988)</source>
        <translation>Répétabilité moyenne (1988)</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Laboratory</source>
        <translation>Laboratoire</translation>
    </message>
    <message>
        <source>Supplier</source>
        <translation>Fournisseur</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Client</translation>
    </message>
    <message numerus="yes">
        <source>%n required statement(s) missing; printed as “–”</source>
        <translation>
            <numerusform>%n information requise manque ; elle sera imprimée « – »</numerusform>
            <numerusform>%n informations requises manquent ; elles seront imprimées « – »</numerusform>
        </translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Report %1</source>
        <translation>Rapport %1</translation>
    </message>
    <message numerus="yes">
        <source>%n page(s) %1 · preview = PDF = paper</source>
        <translation>
            <numerusform>%n page %1 · aperçu = PDF = papier</numerusform>
            <numerusform>%n pages %1 · aperçu = PDF = papier</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>Fichiers PDF (*.pdf)</translation>
    </message>
    <message>
        <source>%1 cannot be saved</source>
        <translation>%1 ne peut pas être enregistré</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Enregistré : %1</translation>
    </message>
    <message>
        <source>The printer did not accept the report.</source>
        <translation>L’imprimante n’a pas accepté le rapport.</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>Page précédente</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Page suivante</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Plus petit</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Plus grand</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largeur</translation>
    </message>
    <message>
        <source>Pages of the report</source>
        <translation>Pages du rapport</translation>
    </message>
    <message>
        <source>Pages in small</source>
        <translation>Pages en petit</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>Both languages</source>
        <translation>Les deux langues</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>P&amp;apier</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Sections</translation>
    </message>
    <message>
        <source>&amp;Save PDF…</source>
        <translation>&amp;Enregistrer le PDF…</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Imprimer…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ResultsModel</name>
    <message>
        <source>quantity</source>
        <translation>grandeur</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>limite</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>verdict</translation>
    </message>
</context>
<context>
    <name>palmer::ui::ResultsPanel</name>
    <message>
        <source>provisional</source>
        <translation>provisoire</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Copy the results as a table (%1)</source>
        <translation>Copier les résultats en tableau (%1)</translation>
    </message>
    <message>
        <source>Copy the results as a table</source>
        <translation>Copier les résultats en tableau</translation>
    </message>
</context>
<context>
    <name>palmer::ui::RightSide</name>
    <message>
        <source>Figure</source>
        <translation>Figure</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Figure, results, findings</source>
        <translation>Figure, résultats, constats</translation>
    </message>
</context>
<context>
    <name>palmer::ui::TargetCard</name>
    <message>
        <source>Target %1</source>
        <translation>Point visé %1</translation>
    </message>
    <message>
        <source>Readings of target %1</source>
        <translation>Relevés du point visé %1</translation>
    </message>
    <message>
        <source>Statistics of target %1</source>
        <translation>Statistiques du point visé %1</translation>
    </message>
    <message>
        <source>bidir.</source>
        <comment>short for bidirectional</comment>
        <translation>bidir.</translation>
    </message>
    <message>
        <source>Previous target</source>
        <translation>Point visé précédent</translation>
    </message>
    <message>
        <source>Next target</source>
        <translation>Point visé suivant</translation>
    </message>
</context>
<context>
    <name>palmer::ui::TestHead</name>
    <message>
        <source>Axis %1</source>
        <translation>Axe %1</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linéaire</translation>
    </message>
    <message>
        <source>rotary</source>
        <translation>rotatif</translation>
    </message>
    <message>
        <source>standard cycle</source>
        <translation>cycle normal</translation>
    </message>
    <message>
        <source>step cycle</source>
        <translation>cycle en pas</translation>
    </message>
    <message>
        <source>Plane %1</source>
        <translation>Plan %1</translation>
    </message>
    <message>
        <source>drift test</source>
        <translation>essai de dérive</translation>
    </message>
    <message>
        <source>View; edition of the test: %1</source>
        <translation>Vue ; édition de l’essai : %1</translation>
    </message>
    <message>
        <source>E&amp;dition</source>
        <translation>Éd&amp;ition</translation>
    </message>
    <message>
        <source>Edition the test is evaluated under</source>
        <translation>Édition selon laquelle l’essai est évalué</translation>
    </message>
    <message>
        <source>Shows the results under another edition; the file stays as it is</source>
        <translation>Montre les résultats selon une autre édition ; le fichier reste tel quel</translation>
    </message>
    <message>
        <source>&amp;Set as edition of the test</source>
        <translation>Définir comme édition de l’&amp;essai</translation>
    </message>
    <message>
        <source>Set as edition of the test</source>
        <translation>Définir comme édition de l’essai</translation>
    </message>
    <message>
        <source>Writes this edition into the test; it can be undone</source>
        <translation>Inscrit cette édition dans l’essai ; peut être annulé</translation>
    </message>
</context>
<context>
    <name>palmer::ui::WelcomePage</name>
    <message>
        <source>Welcome</source>
        <translation>Accueil</translation>
    </message>
    <message>
        <source>Tests of machine tools: measure, judge, print the report</source>
        <translation>Essais de machines-outils : mesurer, juger, imprimer le rapport</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>a test file, .palmer</source>
        <translation>un fichier d’essais, .palmer</translation>
    </message>
    <message>
        <source>or drop a file into the window — .palmer</source>
        <translation>ou déposez un fichier dans la fenêtre — .palmer</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>No file yet. Begin with an example below.</source>
        <translation>Aucun fichier pour l’instant. Commencez par un exemple ci-dessous.</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>verified results</source>
        <translation>résultats vérifiés</translation>
    </message>
</context>
<context>
    <name>palmer::ui::Workplace</name>
    <message numerus="yes">
        <source>%n target(s)</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n passe</numerusform>
            <numerusform>%n passes</numerusform>
        </translation>
    </message>
    <message>
        <source>target %1, run %2 %3: %4</source>
        <translation>point %1, passe %2 %3 : %4</translation>
    </message>
    <message>
        <source>no reading</source>
        <translation>pas de relevé</translation>
    </message>
    <message>
        <source>Test report</source>
        <translation>Rapport d’essai</translation>
    </message>
    <message>
        <source>Pages of the test</source>
        <translation>Pages de l’essai</translation>
    </message>
    <message>
        <source>&amp;Readings</source>
        <translation>&amp;Relevés</translation>
    </message>
    <message>
        <source>&amp;Conditions</source>
        <translation>&amp;Conditions</translation>
    </message>
    <message>
        <source>&amp;Agreed points</source>
        <translation>&amp;Points convenus</translation>
    </message>
    <message>
        <source>&amp;Limits</source>
        <translation>&amp;Limites</translation>
    </message>
</context>
<context>
    <name>palmer::ui::testName</name>
    <message>
        <source>%1 circle</source>
        <translation>Cercle %1</translation>
    </message>
    <message>
        <source>%1 axis</source>
        <translation>Axe %1</translation>
    </message>
</context>
</TS>
