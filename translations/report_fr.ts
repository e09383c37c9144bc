<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr">
<context>
    <name>report</name>
    <message>
        <source>January</source>
        <translation>janvier</translation>
    </message>
    <message>
        <source>February</source>
        <translation>février</translation>
    </message>
    <message>
        <source>March</source>
        <translation>mars</translation>
    </message>
    <message>
        <source>April</source>
        <translation>avril</translation>
    </message>
    <message>
        <source>May</source>
        <translation>mai</translation>
    </message>
    <message>
        <source>June</source>
        <translation>juin</translation>
    </message>
    <message>
        <source>July</source>
        <translation>juillet</translation>
    </message>
    <message>
        <source>August</source>
        <translation>août</translation>
    </message>
    <message>
        <source>September</source>
        <translation>septembre</translation>
    </message>
    <message>
        <source>October</source>
        <translation>octobre</translation>
    </message>
    <message>
        <source>November</source>
        <translation>novembre</translation>
    </message>
    <message>
        <source>December</source>
        <translation>décembre</translation>
    </message>
    <message>
        <source>No value for %1: the test has no targets.</source>
        <translation>Pas de valeur pour %1&#xa0;: l’essai n’a aucun point visé.</translation>
    </message>
    <message>
        <source>No value for %1: target %2 has no reading.</source>
        <translation>Pas de valeur pour %1&#xa0;: le point visé %2 n’a aucun relevé.</translation>
    </message>
    <message>
        <source>No value for %1: target %2 has no s.</source>
        <translation>Pas de valeur pour %1&#xa0;: le point visé %2 n’a pas de s.</translation>
    </message>
    <message>
        <source>The limit of %1 has no verdict: this test has no such parameter under %2.</source>
        <translation>La limite de %1 reste sans verdict&#xa0;: sous %2, cet essai n’a pas ce paramètre.</translation>
    </message>
    <message>
        <source>The limit of %1 has no verdict: it was agreed for %2, the test is evaluated under %3.</source>
        <translation>La limite de %1 reste sans verdict&#xa0;: elle a été convenue pour %2, l’essai est évalué selon %3.</translation>
    </message>
    <message>
        <source>The decision rule needs the measurement uncertainty: without it nothing is proven.</source>
        <translation>La règle de décision exige l’incertitude de mesure&#xa0;: sans elle, rien n’est prouvé.</translation>
    </message>
    <message>
        <source>Not stated: %1.</source>
        <translation>Non indiqué&#xa0;: %1.</translation>
    </message>
    <message>
        <source>To be agreed between supplier/manufacturer and user, not agreed: %1.</source>
        <translation>Soumis à accord entre le fournisseur/constructeur et l’utilisateur, non convenu&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The machine was at %1 on average and the results are not corrected to 20 °C.</source>
        <translation>La machine était à %1 en moyenne et les résultats ne sont pas ramenés à 20&#xa0;°C.</translation>
    </message>
    <message>
        <source>Temperature %1: where it can be controlled, 20 °C ± 0.5 °C are asked for.</source>
        <translation>Température %1&#xa0;: lorsqu’elle peut être régulée, 20&#xa0;°C ±&#xa0;0,5&#xa0;°C sont demandés.</translation>
    </message>
    <message>
        <source>The correction to 20 °C cannot be applied: it needs the temperatures at start and end and the coefficients of thermal expansion of machine and instrument (0 for a laser whose compensation covers the air only).</source>
        <translation>La correction à 20&#xa0;°C ne peut pas être appliquée&#xa0;: il y faut les températures au début et à la fin ainsi que les coefficients de dilatation thermique de la machine et de l’instrument (0 pour un laser dont la compensation ne porte que sur l’air).</translation>
    </message>
    <message>
        <source>A rotary axis has no correction to 20 °C: none was applied.</source>
        <translation>Un axe rotatif n’a pas de correction à 20&#xa0;°C&#xa0;: aucune n’a été appliquée.</translation>
    </message>
    <message>
        <source>The stated uncertainty of the expansion coefficient of the machine, %1, is below the typical minimum of %2.</source>
        <translation>L’incertitude indiquée du coefficient de dilatation de la machine, %1, est inférieure au minimum usuel de %2.</translation>
    </message>
    <message>
        <source>The machine was not complete.</source>
        <translation>La machine n’était pas complète.</translation>
    </message>
    <message>
        <source>The machine was not levelled and aligned.</source>
        <translation>La machine n’était pas mise à niveau ni alignée.</translation>
    </message>
    <message>
        <source>The machine was not unloaded.</source>
        <translation>La machine n’était pas à vide.</translation>
    </message>
    <message>
        <source>A dry run without an agreed warm-up: only the movements needed to set up the instrument are allowed.</source>
        <translation>Essai à blanc préalable sans mise en température convenue&#xa0;: seuls les mouvements nécessaires au réglage de l’instrument sont admis.</translation>
    </message>
    <message>
        <source>The warm-up procedure is neither described nor agreed.</source>
        <translation>La procédure de mise en température n’est ni décrite ni convenue.</translation>
    </message>
    <message>
        <source>Not stated: compensation active during the test.</source>
        <translation>Non indiqué&#xa0;: compensation active pendant l’essai.</translation>
    </message>
    <message>
        <source>The measurement uncertainty is not stated beside every result.</source>
        <translation>L’incertitude de mesure n’est pas indiquée à côté de chaque résultat.</translation>
    </message>
    <message>
        <source>Acceptance code for machine tools — Part 2: Determination of accuracy and repeatability of positioning of numerically controlled machine tools</source>
        <translation>Code de réception des machines-outils — Partie 2&#xa0;: Détermination de la précision et de la répétabilité de positionnement des machines-outils à commande numérique</translation>
    </message>
    <message>
        <source>Test code for machine tools — Part 2: Determination of accuracy and repeatability of positioning numerically controlled axes</source>
        <translation>Code d’essai des machines-outils — Partie 2&#xa0;: Détermination de l’exactitude et de la répétabilité de positionnement des axes en commande numérique</translation>
    </message>
    <message>
        <source>No reading at %1 (%n in all): the statistics use the readings that exist.</source>
        <translation>Aucun relevé en %1 (%n au total)&#xa0;: la statistique emploie les relevés existants.</translation>
    </message>
    <message>
        <source>Approaches in the positive direction: %1, in the negative: %2; 5 each way are required.</source>
        <translation>Approches dans le sens positif&#xa0;: %1, dans le sens négatif&#xa0;: %2&#x202f;; 5 par sens sont exigées.</translation>
    </message>
    <message>
        <source>Approaches in the positive direction: %1, in the negative: %2; practice asks for 5 each way (not verified against the text of the edition).</source>
        <translation>Approches dans le sens positif&#xa0;: %1, dans le sens négatif&#xa0;: %2&#x202f;; l’usage en demande 5 par sens (non vérifié sur le texte de l’édition).</translation>
    </message>
    <message>
        <source>Approaches in the positive direction: %1, in the negative: %2; at least 1 each way is required.</source>
        <translation>Approches dans le sens positif&#xa0;: %1, dans le sens négatif&#xa0;: %2&#x202f;; au moins 1 par sens est exigée.</translation>
    </message>
    <message>
        <source>Approaches in the positive direction: %1, in the negative: %2; practice asks for at least 1 each way (not verified against the text of the edition).</source>
        <translation>Approches dans le sens positif&#xa0;: %1, dans le sens négatif&#xa0;: %2&#x202f;; l’usage en demande au moins 1 par sens (non vérifié sur le texte de l’édition).</translation>
    </message>
    <message>
        <source>Runs in the positive direction: %1, in the negative: %2; each direction is evaluated with its own.</source>
        <translation>Séries dans le sens positif&#xa0;: %1, dans le sens négatif&#xa0;: %2&#x202f;; chaque sens est évalué avec les siennes.</translation>
    </message>
    <message>
        <source>Readings set aside (%n): %1. The standard knows no rejection of readings.</source>
        <translation>Relevés écartés (%n)&#xa0;: %1. La norme ne connaît pas de rejet de relevés.</translation>
    </message>
    <message>
        <source>Readings set aside without a reason: %n.</source>
        <translation>Relevés écartés sans motif&#xa0;: %n.</translation>
    </message>
    <message>
        <source>The range method for s belongs to ISO 230-2:1988 only: s is calculated here.</source>
        <translation>La méthode de l’étendue pour s n’appartient qu’à l’ISO 230-2:1988&#xa0;: s est calculé ici.</translation>
    </message>
    <message>
        <source>The range method is defined for 2 to 10 readings; target %1 has %2.</source>
        <translation>La méthode de l’étendue est définie pour 2 à 10 relevés&#x202f;; le point visé %1 en a %2.</translation>
    </message>
    <message>
        <source>The deviations at the same target progress steadily from approach to approach: D = %1 from the first to the last (t = %2, above %3). The thermal conditions may be unstable.</source>
        <translation>Les écarts à un même point visé progressent régulièrement d’une approche à l’autre&#xa0;: D = %1 de la première à la dernière (t = %2, au-dessus de %3). Les conditions thermiques sont peut-être instables.</translation>
    </message>
    <message>
        <source>The deviations at the same target progress steadily from approach to approach: D = %1 from the first to the last, beside %4 = %5 (t = %2, above %3). The thermal conditions may be unstable.</source>
        <translation>Les écarts à un même point visé progressent régulièrement d’une approche à l’autre&#xa0;: D = %1 de la première à la dernière, à côté de %4 = %5 (t = %2, au-dessus de %3). Les conditions thermiques sont peut-être instables.</translation>
    </message>
    <message>
        <source>Step cycle without a written agreement: not an acceptance result under this standard.</source>
        <translation>Cycle en pas sans accord écrit&#xa0;: ce n’est pas un résultat de réception selon cette norme.</translation>
    </message>
    <message>
        <source>largest temperature gradient, 12 h before and during the test</source>
        <translation>plus grand gradient de température, 12&#xa0;h avant et pendant l’essai</translation>
    </message>
    <message>
        <source>position of the measuring reference</source>
        <translation>position de la référence de mesurage</translation>
    </message>
    <message>
        <source>warm-up</source>
        <translation>mise en température</translation>
    </message>
    <message>
        <source>feed rate between targets, when not rapid</source>
        <translation>vitesse d’avance entre les points visés, si elle n’est pas rapide</translation>
    </message>
    <message>
        <source>measuring cycle</source>
        <translation>cycle de mesurage</translation>
    </message>
    <message>
        <source>place of the 2 m working zone</source>
        <translation>emplacement de la zone de travail de 2&#xa0;m</translation>
    </message>
    <message>
        <source>temperature gradient, 12 h before and during the test</source>
        <translation>gradient de température, 12&#xa0;h avant et pendant l’essai</translation>
    </message>
    <message>
        <source>position of the instrument and of the temperature sensors</source>
        <translation>position de l’instrument et des capteurs de température</translation>
    </message>
    <message>
        <source>feed rate between targets</source>
        <translation>vitesse d’avance entre les points visés</translation>
    </message>
    <message>
        <source>place of the working zone of 2 000 mm or 360°</source>
        <translation>emplacement de la zone de travail de 2&#x202f;000&#xa0;mm ou 360°</translation>
    </message>
    <message>
        <source>position of the axes not under test</source>
        <translation>position des axes non soumis à l’essai</translation>
    </message>
    <message>
        <source>dwell at each target</source>
        <translation>temps d’arrêt à chaque point visé</translation>
    </message>
    <message>
        <source>first and last target</source>
        <translation>premier et dernier points visés</translation>
    </message>
    <message>
        <source>step cycle</source>
        <translation>cycle en pas</translation>
    </message>
    <message>
        <source>accuracy of an axis</source>
        <comment>A</comment>
        <translation>précision d’un axe</translation>
    </message>
    <message>
        <source>accuracy of an axis</source>
        <comment>A↑, A↓</comment>
        <translation>précision d’un axe, unidirectionnelle</translation>
    </message>
    <message>
        <source>bi-directional repeatability of positioning of an axis</source>
        <translation>répétabilité de positionnement bidirectionnelle d’un axe</translation>
    </message>
    <message>
        <source>unidirectional repeatability of positioning of an axis</source>
        <translation>répétabilité de positionnement unidirectionnelle d’un axe</translation>
    </message>
    <message>
        <source>mean reversal value of an axis</source>
        <comment>1988</comment>
        <translation>erreur moyenne de réversibilité</translation>
    </message>
    <message>
        <source>mean repeatability</source>
        <translation>valeur moyenne de répétabilité</translation>
    </message>
    <message>
        <source>bi-directional accuracy of positioning of an axis</source>
        <translation>exactitude bidirectionnelle de positionnement d’un axe</translation>
    </message>
    <message>
        <source>unidirectional accuracy of positioning of an axis</source>
        <translation>exactitude unidirectionnelle de positionnement d’un axe</translation>
    </message>
    <message>
        <source>bi-directional systematic positional deviation of an axis</source>
        <translation>écart de position systématique bidirectionnel d’un axe</translation>
    </message>
    <message>
        <source>unidirectional systematic positional deviation of an axis</source>
        <translation>écart de position systématique unidirectionnel d’un axe</translation>
    </message>
    <message>
        <source>range of the mean bi-directional positional deviation of an axis</source>
        <translation>étendue de l’écart de position bidirectionnel moyen d’un axe</translation>
    </message>
    <message>
        <source>reversal value of an axis</source>
        <translation>valeur de réversibilité d’un axe</translation>
    </message>
    <message>
        <source>mean reversal value of an axis</source>
        <translation>valeur moyenne de réversibilité d’un axe</translation>
    </message>
    <message>
        <source>bi-directional positioning accuracy of an axis</source>
        <translation>exactitude bidirectionnelle de positionnement d’un axe</translation>
    </message>
    <message>
        <source>unidirectional positioning accuracy of an axis</source>
        <translation>exactitude unidirectionnelle de positionnement d’un axe</translation>
    </message>
    <message>
        <source>bi-directional systematic positioning error of an axis</source>
        <translation>écart de position systématique bidirectionnel d’un axe</translation>
    </message>
    <message>
        <source>unidirectional systematic positioning error of an axis</source>
        <translation>écart de position systématique unidirectionnel d’un axe</translation>
    </message>
    <message>
        <source>mean bi-directional positioning error of an axis</source>
        <translation>étendue de l’écart de position bidirectionnel moyen d’un axe</translation>
    </message>
    <message>
        <source>bi-directional positioning repeatability of an axis</source>
        <translation>répétabilité de positionnement bidirectionnelle d’un axe</translation>
    </message>
    <message>
        <source>unidirectional positioning repeatability of an axis</source>
        <translation>répétabilité de positionnement unidirectionnelle d’un axe</translation>
    </message>
    <message>
        <source>unidirectional positioning repeatability (UPR)</source>
        <translation>répétabilité de positionnement unidirectionnelle (UPR)</translation>
    </message>
    <message>
        <source>reversal error of an axis</source>
        <translation>valeur de réversibilité d’un axe</translation>
    </message>
    <message>
        <source>mean reversal error of an axis</source>
        <translation>valeur moyenne de réversibilité d’un axe</translation>
    </message>
    <message>
        <source>positional uncertainty (VDI: Positionsunsicherheit)</source>
        <translation>incertitude de position (VDI&#xa0;: Positionsunsicherheit)</translation>
    </message>
    <message>
        <source>positional deviation (VDI: Positionsabweichung)</source>
        <translation>écart de position (VDI&#xa0;: Positionsabweichung)</translation>
    </message>
    <message>
        <source>positional scatter (VDI: Positionsstreubreite), largest</source>
        <translation>dispersion de position (VDI&#xa0;: Positionsstreubreite), la plus grande</translation>
    </message>
    <message>
        <source>positional scatter (VDI: Positionsstreubreite), mean</source>
        <translation>dispersion de position (VDI&#xa0;: Positionsstreubreite), moyenne</translation>
    </message>
    <message>
        <source>reversal range (VDI: Umkehrspanne), largest</source>
        <translation>réversibilité (VDI&#xa0;: Umkehrspanne), la plus grande</translation>
    </message>
    <message>
        <source>reversal range (VDI: Umkehrspanne), mean</source>
        <translation>réversibilité (VDI&#xa0;: Umkehrspanne), moyenne</translation>
    </message>
    <message>
        <source>mean unidirectional positional deviation at a position</source>
        <comment>1988</comment>
        <translation>écart de position unidirectionnel moyen à une position</translation>
    </message>
    <message>
        <source>mean bi-directional positional deviation at a position</source>
        <translation>écart de position bidirectionnel moyen en un point</translation>
    </message>
    <message>
        <source>reversal value at a position</source>
        <comment>1988</comment>
        <translation>erreur de réversibilité en une position</translation>
    </message>
    <message>
        <source>range of the positional deviation</source>
        <translation>étendue de l’écart de position</translation>
    </message>
    <message>
        <source>estimator of the standard deviation</source>
        <translation>estimateur de l’écart-type</translation>
    </message>
    <message>
        <source>unidirectional repeatability of positioning at a position</source>
        <comment>1988</comment>
        <translation>répétabilité de positionnement unidirectionnelle en un point visé</translation>
    </message>
    <message>
        <source>bi-directional repeatability of positioning at a position</source>
        <comment>1988</comment>
        <translation>répétabilité de positionnement bidirectionnelle en un point visé</translation>
    </message>
    <message>
        <source>mean unidirectional positional deviation at a position</source>
        <translation>écart de position unidirectionnel moyen en un point</translation>
    </message>
    <message>
        <source>reversal value at a position</source>
        <translation>valeur de réversibilité en un point</translation>
    </message>
    <message>
        <source>estimator of the unidirectional axis repeatability of positioning at a position</source>
        <translation>estimateur de la répétabilité de l’axe unidirectionnelle du positionnement en un point</translation>
    </message>
    <message>
        <source>unidirectional repeatability of positioning at a position</source>
        <translation>répétabilité de positionnement unidirectionnelle en un point</translation>
    </message>
    <message>
        <source>bi-directional repeatability of positioning at a position</source>
        <translation>répétabilité de positionnement bidirectionnelle en un point</translation>
    </message>
    <message>
        <source>mean unidirectional positioning deviation at a position</source>
        <translation>écart de position unidirectionnel moyen en un point</translation>
    </message>
    <message>
        <source>mean bi-directional positioning deviation at a position</source>
        <translation>écart de position bidirectionnel moyen en un point</translation>
    </message>
    <message>
        <source>reversal error at a position</source>
        <translation>valeur de réversibilité en un point</translation>
    </message>
    <message>
        <source>estimator for unidirectional axis positioning repeatability at a position</source>
        <translation>estimateur de la répétabilité de l’axe unidirectionnelle du positionnement en un point</translation>
    </message>
    <message>
        <source>unidirectional positioning repeatability at a position</source>
        <translation>répétabilité de positionnement unidirectionnelle en un point</translation>
    </message>
    <message>
        <source>bi-directional positioning repeatability at a position</source>
        <translation>répétabilité de positionnement bidirectionnelle en un point</translation>
    </message>
    <message>
        <source>date of the test</source>
        <translation>date de l’essai</translation>
    </message>
    <message>
        <source>manufacturer of the machine</source>
        <translation>constructeur de la machine</translation>
    </message>
    <message>
        <source>type of the machine</source>
        <translation>type de la machine</translation>
    </message>
    <message>
        <source>serial number of the machine</source>
        <translation>numéro de série de la machine</translation>
    </message>
    <message>
        <source>name of the axis</source>
        <translation>désignation de l’axe</translation>
    </message>
    <message>
        <source>measuring system of the axis</source>
        <translation>système de mesure de l’axe</translation>
    </message>
    <message>
        <source>how the targets were chosen</source>
        <translation>choix des points visés</translation>
    </message>
    <message>
        <source>instrument</source>
        <translation>instrument de mesure</translation>
    </message>
    <message>
        <source>serial number of each instrument</source>
        <translation>numéro de série de chaque instrument</translation>
    </message>
    <message>
        <source>calibration certificate of each instrument</source>
        <translation>certificat d’étalonnage de chaque instrument</translation>
    </message>
    <message>
        <source>calibration date of each instrument</source>
        <translation>date d’étalonnage de chaque instrument</translation>
    </message>
    <message>
        <source>measuring line: offset to the tool reference</source>
        <translation>ligne de mesurage&#xa0;: décalage par rapport à la référence de l’outil</translation>
    </message>
    <message>
        <source>measuring line: offset to the workpiece reference</source>
        <translation>ligne de mesurage&#xa0;: décalage par rapport à la référence de la pièce</translation>
    </message>
    <message>
        <source>temperature of the machine at start and end</source>
        <translation>température de la machine au début et à la fin</translation>
    </message>
    <message>
        <source>temperature of the instrument at start and end</source>
        <translation>température de l’instrument au début et à la fin</translation>
    </message>
    <message>
        <source>temperature of the air at start and end</source>
        <translation>température de l’air au début et à la fin</translation>
    </message>
    <message>
        <source>position of the temperature sensors</source>
        <translation>position des capteurs de température</translation>
    </message>
    <message>
        <source>coefficients of thermal expansion of machine and instrument</source>
        <translation>coefficients de dilatation thermique de la machine et de l’instrument</translation>
    </message>
    <message>
        <source>compensation of the nominal differential expansion (NDE)</source>
        <translation>compensation de la dilatation différentielle nominale (DDN)</translation>
    </message>
    <message>
        <source>air pressure</source>
        <translation>pression de l’air</translation>
    </message>
    <message>
        <source>air humidity</source>
        <translation>humidité de l’air</translation>
    </message>
    <message>
        <source>temperature gradient</source>
        <translation>gradient de température</translation>
    </message>
    <message>
        <source>warm-up done</source>
        <translation>mise en température effectuée</translation>
    </message>
    <message>
        <source>feed rate</source>
        <translation>vitesse d’avance</translation>
    </message>
    <message>
        <source>machine complete and in working order</source>
        <translation>machine complète et en état de marche</translation>
    </message>
    <message>
        <source>machine levelled and aligned</source>
        <translation>machine mise à niveau et alignée</translation>
    </message>
    <message>
        <source>machine unloaded</source>
        <translation>machine à vide</translation>
    </message>
    <message>
        <source>Axis travel not stated: the measurement travel of %1 takes its place.</source>
        <translation>Longueur d’axe non indiquée&#xa0;: la course de mesurage de %1 en tient lieu.</translation>
    </message>
    <message>
        <source>%1 targets over %2: at least 5 per metre are required, %3 here.</source>
        <translation>%1 points visés sur %2&#xa0;: au moins 5 par mètre sont exigés, soit %3 ici.</translation>
    </message>
    <message>
        <source>Number of targets: %1; at least 5 are required.</source>
        <translation>Nombre de points visés&#xa0;: %1&#x202f;; au moins 5 sont exigés.</translation>
    </message>
    <message>
        <source>%1 targets over %2: a long axis has a target in each element of its measuring system or every 250 mm.</source>
        <translation>%1 points visés sur %2&#xa0;: un axe long a un point visé dans chaque élément de son système de mesure ou tous les 250&#xa0;mm.</translation>
    </message>
    <message>
        <source>%1 targets over %2: practice asks for a mean interval of 250 mm and a target in each segment of the scale (not verified against the text of the edition).</source>
        <translation>%1 points visés sur %2&#xa0;: l’usage demande un intervalle moyen de 250&#xa0;mm et un point visé dans chaque segment de la règle (non vérifié sur le texte de l’édition).</translation>
    </message>
    <message>
        <source>The targets leave out %1 of the axis travel of %2: neither the whole travel nor a test inside the agreed zone.</source>
        <translation>Les points visés laissent de côté %1 de la longueur d’axe de %2&#xa0;: ce n’est ni la longueur entière ni un essai dans la zone convenue.</translation>
    </message>
    <message>
        <source>The targets leave out %1 of the axis travel of %2: practice asks for the whole travel (not verified against the text of the edition).</source>
        <translation>Les points visés laissent de côté %1 de la longueur d’axe de %2&#xa0;: l’usage demande la longueur entière (non vérifié sur le texte de l’édition).</translation>
    </message>
    <message>
        <source>A rotary axis is tested at 0°, 90°, 180° and 270° or at the faces of the polygon; missing: %1.</source>
        <translation>Un axe rotatif est contrôlé à 0°, 90°, 180° et 270° ou aux faces du polygone&#x202f;; manquent&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 targets over %2: practice asks for at least %3 (not verified against the text of the edition).</source>
        <translation>%1 points visés sur %2&#xa0;: l’usage en demande au moins %3 (non vérifié sur le texte de l’édition).</translation>
    </message>
    <message>
        <source>%1 targets over %2: practice asks for at least 8 per turn, up to 1 800° (not verified against the text of the edition).</source>
        <translation>%1 points visés sur %2&#xa0;: l’usage en demande au moins 8 par tour, jusqu’à 1&#x202f;800° (non vérifié sur le texte de l’édition).</translation>
    </message>
    <message>
        <source>Only the zone of this long axis (%1) is tested: the test over the whole travel is missing in this file.</source>
        <translation>Seule la zone de cet axe long (%1) est contrôlée&#xa0;: l’essai sur la longueur entière manque dans ce fichier.</translation>
    </message>
    <message>
        <source>Only the whole travel of this long axis (%1) is tested: the full test of an agreed zone of %2 is missing in this file.</source>
        <translation>Seule la longueur entière de cet axe long (%1) est contrôlée&#xa0;: le contrôle complet d’une zone convenue de %2 manque dans ce fichier.</translation>
    </message>
    <message>
        <source>The zone is %1 long; the full test is made on an agreed %2.</source>
        <translation>La zone a une longueur de %1&#x202f;; le contrôle complet se fait sur une longueur convenue de %2.</translation>
    </message>
    <message>
        <source>The zone is %1 long; practice asks for a full test on an agreed %2 (not verified against the text of the edition).</source>
        <translation>La zone a une longueur de %1&#x202f;; l’usage demande un contrôle complet sur une longueur convenue de %2 (non vérifié sur le texte de l’édition).</translation>
    </message>
    <message>
        <source>The first and the last target have to be approached from both sides; beyond them the axis has %1 and %2, the approach distance is %3.</source>
        <translation>Le premier et le dernier points visés doivent être approchés des deux côtés&#x202f;; au-delà, l’axe dispose de %1 et de %2, la distance d’approche est de %3.</translation>
    </message>
    <message>
        <source>The first and the last target have to be approached from both sides; beyond them the axis has %1 and %2.</source>
        <translation>Le premier et le dernier points visés doivent être approchés des deux côtés&#x202f;; au-delà, l’axe dispose de %1 et de %2.</translation>
    </message>
    <message>
        <source>The ends of the axis are not stated: whether the first and the last target can be approached from both sides is not checked.</source>
        <translation>Les extrémités de l’axe ne sont pas indiquées&#xa0;: il n’est pas vérifié que le premier et le dernier points visés peuvent être approchés des deux côtés.</translation>
    </message>
    <message>
        <source>The targets are evenly spaced (%1): with a new random part for every target periodic errors do not stay hidden.</source>
        <translation>Les points visés sont équidistants (%1)&#xa0;: avec une nouvelle part aléatoire pour chaque point visé, les erreurs périodiques ne restent pas cachées.</translation>
    </message>
    <message>
        <source>All intervals are whole multiples of the period of %1: its periodic error stays hidden.</source>
        <translation>Tous les intervalles sont des multiples entiers de la période de %1&#xa0;: son erreur périodique reste cachée.</translation>
    </message>
    <message>
        <source>The targets leave their nominal interval of %1 by up to ± %2; the random part is to stay within ± %3.</source>
        <translation>Les points visés s’écartent de leur intervalle nominal de %1 jusqu’à ±&#xa0;%2&#x202f;; la part aléatoire doit rester dans ±&#xa0;%3.</translation>
    </message>
    <message>
        <source>Test code for machine tools — Part 4: Circular tests for numerically controlled machine tools</source>
        <translation>Code d’essai des machines-outils — Partie 4&#xa0;: Essais de circularité des machines-outils à commande numérique</translation>
    </message>
    <message>
        <source>test parameters</source>
        <translation>paramètres de l’essai</translation>
    </message>
    <message>
        <source>which of the results are required</source>
        <translation>résultats demandés</translation>
    </message>
    <message>
        <source>“{”</source>
        <translation>«&#xa0;{&#xa0;»</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>la fin du fichier</translation>
    </message>
    <message>
        <source>more values than a test file can have</source>
        <translation>plus de valeurs qu’un fichier d’essai ne peut en contenir</translation>
    </message>
    <message>
        <source>a key in quotation marks or “}”</source>
        <translation>une clé entre guillemets ou «&#xa0;}&#xa0;»</translation>
    </message>
    <message>
        <source>a key in quotation marks</source>
        <translation>une clé entre guillemets</translation>
    </message>
    <message>
        <source>this key stands here twice; expected it once</source>
        <translation>cette clé figure ici deux fois&#x202f;; attendu&#xa0;: une seule fois</translation>
    </message>
    <message>
        <source>more keys than a test file can have</source>
        <translation>plus de clés qu’un fichier d’essai ne peut en contenir</translation>
    </message>
    <message>
        <source>“:”</source>
        <translation>«&#xa0;:&#xa0;»</translation>
    </message>
    <message>
        <source>“,” or “}”</source>
        <translation>«&#xa0;,&#xa0;» ou «&#xa0;}&#xa0;»</translation>
    </message>
    <message>
        <source>“,” or “]”</source>
        <translation>«&#xa0;,&#xa0;» ou «&#xa0;]&#xa0;»</translation>
    </message>
    <message>
        <source>more than 10 000 000 readings or points</source>
        <translation>plus de 10&#x202f;000&#x202f;000 de relevés ou de points</translation>
    </message>
    <message>
        <source>nested deeper than a test file can be</source>
        <translation>imbrication plus profonde qu’un fichier d’essai ne l’admet</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>une valeur</translation>
    </message>
    <message>
        <source>this number is too large; expected a finite number</source>
        <translation>ce nombre est trop grand&#x202f;; attendu&#xa0;: un nombre fini</translation>
    </message>
    <message>
        <source>the file ends inside this text; expected a quotation mark</source>
        <translation>le fichier s’arrête à l’intérieur de ce texte&#x202f;; attendu&#xa0;: un guillemet</translation>
    </message>
    <message>
        <source>a text cannot hold this character; expected UTF-8 without line breaks and control characters</source>
        <translation>un texte ne peut pas contenir ce caractère&#x202f;; attendu&#xa0;: de l’UTF-8 sans saut de ligne ni caractère de commande</translation>
    </message>
    <message>
        <source>the file ends here; expected %1</source>
        <translation>le fichier s’arrête ici&#x202f;; attendu&#xa0;: %1</translation>
    </message>
    <message>
        <source>this is no character of UTF-8; expected a test file in UTF-8</source>
        <translation>ceci n’est pas un caractère UTF-8&#x202f;; attendu&#xa0;: un fichier d’essai en UTF-8</translation>
    </message>
    <message>
        <source>found “%1”; expected %2</source>
        <translation>trouvé&#xa0;: «&#xa0;%1&#xa0;»&#x202f;; attendu&#xa0;: %2</translation>
    </message>
    <message>
        <source>a file cannot hold a number that is not finite</source>
        <translation>un fichier ne peut pas contenir un nombre qui n’est pas fini</translation>
    </message>
    <message>
        <source>this key is unknown; what others want to add goes into “extensions”</source>
        <translation>cette clé est inconnue&#x202f;; ce que d’autres veulent ajouter se place dans «&#xa0;extensions&#xa0;»</translation>
    </message>
    <message>
        <source>expected “from” to be less than “to”</source>
        <translation>attendu&#xa0;: «&#xa0;from&#xa0;» inférieur à «&#xa0;to&#xa0;»</translation>
    </message>
    <message>
        <source>expected targets that ascend strictly</source>
        <translation>attendu&#xa0;: des points visés strictement croissants</translation>
    </message>
    <message>
        <source>expected one of the %1 runs, counted from 1</source>
        <translation>attendu&#xa0;: un numéro de parcours de 1 à %1</translation>
    </message>
    <message>
        <source>expected one of the %1 targets, counted from 1</source>
        <translation>attendu&#xa0;: un numéro de point visé de 1 à %1</translation>
    </message>
    <message>
        <source>expected null, for this reading stands in “excluded”</source>
        <translation>attendu&#xa0;: null, car ce relevé figure dans «&#xa0;excluded&#xa0;»</translation>
    </message>
    <message>
        <source>this reading is excluded twice; expected it once</source>
        <translation>ce relevé est écarté deux fois&#x202f;; attendu&#xa0;: une seule fois</translation>
    </message>
    <message>
        <source>unknown edition “%1”; expected a designation such as ISO 230-2:1988</source>
        <translation>édition «&#xa0;%1&#xa0;» inconnue&#x202f;; attendu&#xa0;: une désignation telle que ISO 230-2:1988</translation>
    </message>
    <message>
        <source>expected at least one language</source>
        <translation>attendu&#xa0;: au moins une langue</translation>
    </message>
    <message>
        <source>unknown parameter “%1”; expected one of this kind of test, such as %2</source>
        <translation>paramètre «&#xa0;%1&#xa0;» inconnu&#x202f;; attendu&#xa0;: un paramètre de ce type d’essai, tel que %2</translation>
    </message>
    <message>
        <source>“%1” is not for this kind of test</source>
        <translation>«&#xa0;%1&#xa0;» ne concerne pas ce type d’essai</translation>
    </message>
    <message>
        <source>unknown point “%1”; expected one that this kind of test agrees on</source>
        <translation>point «&#xa0;%1&#xa0;» inconnu&#x202f;; attendu&#xa0;: un point faisant l’objet d’un accord pour ce type d’essai</translation>
    </message>
    <message>
        <source>“%1” stands here twice; expected it once</source>
        <translation>«&#xa0;%1&#xa0;» figure ici deux fois&#x202f;; attendu&#xa0;: une seule fois</translation>
    </message>
    <message>
        <source>expected the id of an instrument of this file; “%1” is none</source>
        <translation>attendu&#xa0;: l’identifiant d’un instrument de ce fichier&#x202f;; «&#xa0;%1&#xa0;» n’en est pas un</translation>
    </message>
    <message>
        <source>expected the id of a drift test of this file; “%1” is none</source>
        <translation>attendu&#xa0;: l’identifiant d’un essai de dérive de ce fichier&#x202f;; «&#xa0;%1&#xa0;» n’en est pas un</translation>
    </message>
    <message>
        <source>the key “%1” is missing</source>
        <translation>la clé «&#xa0;%1&#xa0;» manque</translation>
    </message>
    <message>
        <source>expected one of the words: %1</source>
        <translation>attendu&#xa0;: l’un des mots suivants&#xa0;: %1</translation>
    </message>
    <message>
        <source>unknown word “%1”; expected one of: %2</source>
        <translation>mot «&#xa0;%1&#xa0;» inconnu&#x202f;; attendu&#xa0;: l’un des mots suivants&#xa0;: %2</translation>
    </message>
    <message>
        <source>expected an object, in braces</source>
        <translation>attendu&#xa0;: un objet, entre accolades</translation>
    </message>
    <message>
        <source>expected a list, in square brackets</source>
        <translation>attendu&#xa0;: une liste, entre crochets</translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation>attendu&#xa0;: un nombre</translation>
    </message>
    <message>
        <source>expected a number greater than 0</source>
        <translation>attendu&#xa0;: un nombre supérieur à 0</translation>
    </message>
    <message>
        <source>expected a number that is not negative</source>
        <translation>attendu&#xa0;: un nombre positif ou nul</translation>
    </message>
    <message>
        <source>expected a whole number</source>
        <translation>attendu&#xa0;: un nombre entier</translation>
    </message>
    <message>
        <source>expected true or false</source>
        <translation>attendu&#xa0;: true ou false</translation>
    </message>
    <message>
        <source>expected a text, in quotation marks</source>
        <translation>attendu&#xa0;: un texte, entre guillemets</translation>
    </message>
    <message>
        <source>expected a date that exists, written YYYY-MM-DD</source>
        <translation>attendu&#xa0;: une date qui existe, écrite AAAA-MM-JJ</translation>
    </message>
    <message>
        <source>expected a time of day, written HH:MM</source>
        <translation>attendu&#xa0;: une heure, écrite HH:MM</translation>
    </message>
    <message>
        <source>expected bytes in base64</source>
        <translation>attendu&#xa0;: des octets en base64</translation>
    </message>
    <message>
        <source>expected a number or null</source>
        <translation>attendu&#xa0;: un nombre ou null</translation>
    </message>
    <message>
        <source>expected a whole number or null</source>
        <translation>attendu&#xa0;: un nombre entier ou null</translation>
    </message>
    <message>
        <source>expected true, false or null</source>
        <translation>attendu&#xa0;: true, false ou null</translation>
    </message>
    <message>
        <source>expected a text, in quotation marks, or null</source>
        <translation>attendu&#xa0;: un texte, entre guillemets, ou null</translation>
    </message>
    <message>
        <source>expected an object, in braces, or null</source>
        <translation>attendu&#xa0;: un objet, entre accolades, ou null</translation>
    </message>
    <message>
        <source>this is not a test file of Palmer; expected %1</source>
        <translation>ceci n’est pas un fichier d’essai de Palmer&#x202f;; attendu&#xa0;: %1</translation>
    </message>
    <message>
        <source>expected a whole number from 1 on</source>
        <translation>attendu&#xa0;: un nombre entier à partir de 1</translation>
    </message>
    <message>
        <source>the file was written by a newer version of Palmer (format %1); this one reads up to format %2: install a newer Palmer</source>
        <translation>le fichier a été écrit par une version plus récente de Palmer (format %1)&#x202f;; celle-ci lit jusqu’au format %2&#xa0;: installez une version plus récente de Palmer</translation>
    </message>
    <message>
        <source>this is a folder; expected the name of a file to save to</source>
        <translation>ceci est un dossier&#x202f;; attendu&#xa0;: le nom du fichier à enregistrer</translation>
    </message>
    <message>
        <source>the folder does not exist; create it or save in another folder</source>
        <translation>le dossier n’existe pas&#x202f;; créez-le ou enregistrez dans un autre dossier</translation>
    </message>
    <message>
        <source>this is a folder; expected a test file</source>
        <translation>ceci est un dossier&#x202f;; attendu&#xa0;: un fichier d’essai</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n’existe pas</translation>
    </message>
    <message>
        <source>the file cannot be read (%1)</source>
        <translation>le fichier ne peut pas être lu (%1)</translation>
    </message>
    <message>
        <source>the file is larger than 1 GiB</source>
        <translation>le fichier dépasse 1&#x202f;Gio</translation>
    </message>
    <message>
        <source>bidirectional</source>
        <translation>bidirectionnel</translation>
    </message>
    <message>
        <source>readings</source>
        <translation>relevés</translation>
    </message>
    <message>
        <source>Positioning deviations of the %1 axis</source>
        <translation>Écarts de position de l’axe %1</translation>
    </message>
    <message>
        <source>Positional deviations of the %1 axis</source>
        <translation>Écarts de position de l’axe %1</translation>
    </message>
    <message>
        <source>Positioning deviation</source>
        <translation>Écart de position</translation>
    </message>
    <message>
        <source>Positional deviation</source>
        <translation>Écart de position</translation>
    </message>
    <message>
        <source>Target position</source>
        <translation>Point visé</translation>
    </message>
    <message>
        <source>linear cycle</source>
        <comment>1988</comment>
        <translation>cycle linéaire</translation>
    </message>
    <message>
        <source>pilgrim step cycle</source>
        <comment>1988</comment>
        <translation>cycle en pas de pèlerin</translation>
    </message>
    <message>
        <source>standard test cycle</source>
        <translation>cycle d’essai normal</translation>
    </message>
    <message>
        <source>conforms</source>
        <translation>conforme</translation>
    </message>
    <message>
        <source>not proven</source>
        <translation>non prouvé</translation>
    </message>
    <message>
        <source>does not conform</source>
        <translation>non conforme</translation>
    </message>
    <message>
        <source>requirement</source>
        <translation>exigence</translation>
    </message>
    <message>
        <source>recommendation</source>
        <translation>recommandation</translation>
    </message>
    <message>
        <source>note</source>
        <translation>note</translation>
    </message>
    <message>
        <source>simple acceptance</source>
        <translation>acceptation simple</translation>
    </message>
    <message>
        <source>ISO 14253-1: conformity to be proven</source>
        <translation>ISO 14253-1&#xa0;: conformité à prouver</translation>
    </message>
    <message>
        <source>non-conformity to be proven</source>
        <translation>non-conformité à prouver</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiquée</translation>
    </message>
    <message>
        <source>not applied</source>
        <translation>non appliquée</translation>
    </message>
    <message>
        <source>applied by the instrument</source>
        <translation>appliquée par l’instrument</translation>
    </message>
    <message>
        <source>applied here</source>
        <translation>appliquée ici</translation>
    </message>
    <message>
        <source>Positioning test of axis %1</source>
        <translation>Essai de positionnement de l’axe %1</translation>
    </message>
    <message>
        <source>Circular test in the plane %1</source>
        <translation>Essai de circularité dans le plan %1</translation>
    </message>
    <message>
        <source>Drift test of axis %1</source>
        <translation>Essai de dérive de l’axe %1</translation>
    </message>
    <message>
        <source>step cycle – not an ISO 230-2 acceptance result</source>
        <translation>cycle en pas – résultat non utilisable en référence à l’ISO 230-2</translation>
    </message>
    <message>
        <source>Seen under another edition than that of the test (%1): no verdict.</source>
        <translation>Vu selon une autre édition que celle de l’essai (%1)&#xa0;: pas de verdict.</translation>
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
        <source>axis travel %1</source>
        <translation>longueur d’axe %1</translation>
    </message>
    <message>
        <source>measurement travel %1</source>
        <translation>course de mesurage %1</translation>
    </message>
    <message>
        <source>m = %1; n = %2 each way</source>
        <translation>m = %1&#x202f;; n = %2 par sens</translation>
    </message>
    <message>
        <source>m = %1; n = %2 ↑, %3 ↓</source>
        <translation>m = %1&#x202f;; n = %2 ↑, %3 ↓</translation>
    </message>
    <message>
        <source>guard band %1 U</source>
        <translation>bande de garde %1 U</translation>
    </message>
    <message>
        <source>Edition</source>
        <translation>Édition</translation>
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
        <source>Working zone</source>
        <translation>Zone de travail</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Cycle</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Points visés</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Écart-type</translation>
    </message>
    <message>
        <source>range method</source>
        <translation>méthode de l’étendue</translation>
    </message>
    <message>
        <source>calculation method</source>
        <translation>méthode de calcul</translation>
    </message>
    <message>
        <source>Correction to 20 °C</source>
        <translation>Correction à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Results per target</source>
        <translation>Résultats par point visé</translation>
    </message>
    <message>
        <source>Environmental variation error (max − min)</source>
        <translation>Erreur de variation environnementale (max − min)</translation>
    </message>
    <message>
        <source>not corrected to 20 °C</source>
        <translation>non corrigé à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Targets i</source>
        <translation>Points i</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>In accordance with %1.</source>
        <translation>Essai conforme à l’édition %1.</translation>
    </message>
    <message numerus="yes">
        <source>NOT in accordance with %1: %n requirement(s) not met.</source>
        <translation>
            <numerusform>Essai NON conforme à l’édition %1&#xa0;: %n exigence non satisfaite.</numerusform>
            <numerusform>Essai NON conforme à l’édition %1&#xa0;: %n exigences non satisfaites.</numerusform>
        </translation>
    </message>
    <message>
        <source>Limits: no verdict.</source>
        <translation>Limites&#xa0;: pas de verdict.</translation>
    </message>
    <message>
        <source>Limits: %1 (%2).</source>
        <translation>Limites&#xa0;: %1 (%2).</translation>
    </message>
    <message>
        <source>Limits: none agreed, no verdict.</source>
        <translation>Limites&#xa0;: aucune convenue, pas de verdict.</translation>
    </message>
    <message>
        <source>No findings.</source>
        <translation>Aucun constat.</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>published</source>
        <translation>publiée</translation>
    </message>
    <message>
        <source>recomputed</source>
        <translation>recalculée</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exacte</translation>
    </message>
    <message>
        <source>certified</source>
        <translation>certifiée</translation>
    </message>
    <message>
        <source>agrees</source>
        <translation>concorde</translation>
    </message>
    <message>
        <source>DOES NOT AGREE</source>
        <translation>NE CONCORDE PAS</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeur</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Attendue</translation>
    </message>
    <message>
        <source>Computed</source>
        <translation>Calculée</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Différence</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>All %1 values agree with the reference data.</source>
        <translation>Les %1 valeurs concordent avec les données de référence.</translation>
    </message>
    <message>
        <source>Values that do NOT agree with the reference data: %1 of %2.</source>
        <translation>Valeurs qui ne concordent PAS avec les données de référence&#xa0;: %1 sur %2.</translation>
    </message>
    <message>
        <source>expected reference data of this program</source>
        <translation>des données de référence de ce programme étaient attendues</translation>
    </message>
    <message>
        <source>findings only: what the edition asks for and the test lacks</source>
        <translation>constatations seules&#xa0;: ce que l’édition demande et qui manque à l’essai</translation>
    </message>
    <message>
        <source>language of tables, findings and errors</source>
        <translation>langue des tableaux, constats et erreurs</translation>
    </message>
    <message>
        <source>this help</source>
        <translation>cette aide</translation>
    </message>
    <message>
        <source>the option --%1 needs a value (%2)</source>
        <translation>l’option --%1 demande une valeur (%2)</translation>
    </message>
    <message>
        <source>the option --%1 takes no value</source>
        <translation>l’option --%1 ne prend pas de valeur</translation>
    </message>
    <message>
        <source>unknown option %1 of the command %2</source>
        <translation>option inconnue %1 de la commande %2</translation>
    </message>
    <message>
        <source>unknown language %1; known: fr, en</source>
        <translation>langue inconnue %1&#x202f;; connues&#xa0;: fr, en</translation>
    </message>
    <message>
        <source>the command %1 needs a file (%2)</source>
        <translation>la commande %1 demande un fichier (%2)</translation>
    </message>
    <message>
        <source>the command %1 takes no file</source>
        <translation>la commande %1 ne prend pas de fichier</translation>
    </message>
    <message>
        <source>version of the program</source>
        <translation>version du programme</translation>
    </message>
    <message>
        <source>palmer-cli evaluates machine-tool tests: positioning of axes (ISO 230-2).</source>
        <translation>palmer-cli évalue des essais de machines-outils&#xa0;: positionnement d’axes (ISO 230-2).</translation>
    </message>
    <message>
        <source>COMMAND [OPTION]… [FILE]…</source>
        <translation>COMMANDE [OPTION]… [FICHIER]…</translation>
    </message>
    <message>
        <source>FILE is a test file (.palmer); - is standard input.</source>
        <translation>FICHIER est un fichier d’essai (.palmer)&#x202f;; - est l’entrée standard.</translation>
    </message>
    <message>
        <source>evaluate the tests of its kind under another edition (a view: no verdicts)</source>
        <translation>évaluer les essais de ce type selon une autre édition (une vue&#xa0;: pas de verdict)</translation>
    </message>
    <message>
        <source>results as JSON; of several files one object a line</source>
        <translation>résultats en JSON&#x202f;; pour plusieurs fichiers, un objet par ligne</translation>
    </message>
    <message>
        <source>unknown edition %1; known: %2</source>
        <translation>édition inconnue %1&#x202f;; connues&#xa0;: %2</translation>
    </message>
    <message>
        <source>results of the tests as a table or as JSON</source>
        <translation>résultats des essais en tableau ou en JSON</translation>
    </message>
    <message>
        <source>evaluates the built-in reference data and compares with the known values</source>
        <translation>évalue les données de référence intégrées et compare aux valeurs connues</translation>
    </message>
    <message>
        <source>standard output cannot be written</source>
        <translation>la sortie standard ne peut pas être écrite</translation>
    </message>
    <message>
        <source>a command is missing; palmer-cli --help lists them</source>
        <translation>il manque une commande&#x202f;; palmer-cli --help les énumère</translation>
    </message>
    <message>
        <source>unknown command %1; palmer-cli --help lists them</source>
        <translation>commande inconnue %1&#x202f;; palmer-cli --help les énumère</translation>
    </message>
    <message>
        <source>unknown escape in a text; expected one that JSON knows</source>
        <translation>séquence d’échappement inconnue dans un texte&#x202f;; attendu&#xa0;: une séquence que JSON connaît</translation>
    </message>
    <message>
        <source>number of values found: %1; expected: %2</source>
        <translation>nombre de valeurs trouvées&#xa0;: %1&#x202f;; attendu&#xa0;: %2</translation>
    </message>
    <message>
        <source>the file could not be saved, for want of permission or space; what was there before is unchanged: save it under another name or in another folder</source>
        <translation>le fichier n’a pas pu être enregistré, faute de droits ou de place&#x202f;; l’ancien fichier est inchangé&#xa0;: enregistrez sous un autre nom ou dans un autre dossier</translation>
    </message>
    <message>
        <source>the file cannot be read; check its permissions and the medium it is on</source>
        <translation>le fichier ne peut pas être lu&#x202f;; vérifiez ses droits d’accès et le support sur lequel il se trouve</translation>
    </message>
    <message>
        <source>No value for %1: see what the test lacks.</source>
        <translation>Pas de valeur pour %1&#xa0;: voir ce qui manque à l’essai.</translation>
    </message>
    <message>
        <source>The test has no measured points in the evaluated range.</source>
        <translation>L’essai n’a aucun point mesuré dans l’étendue évaluée.</translation>
    </message>
    <message>
        <source>The path %1 covers %2: at least 90° are required.</source>
        <translation>La trajectoire %1 couvre %2&#xa0;: au moins 90° sont exigés.</translation>
    </message>
    <message>
        <source>Only the path %1 was measured: bi-directional results need both senses.</source>
        <translation>Seule la trajectoire %1 a été mesurée&#xa0;: les résultats bidirectionnels demandent les deux sens.</translation>
    </message>
    <message>
        <source>No value for D: it needs full circles in both senses.</source>
        <translation>Pas de valeur pour D&#xa0;: il demande des cercles complets dans les deux sens.</translation>
    </message>
    <message>
        <source>No value for F of a partial arc: the least squares centre is for full circles only.</source>
        <translation>Pas de valeur pour F d’un arc partiel&#xa0;: le centre des moindres carrés ne vaut que pour des cercles complets.</translation>
    </message>
    <message>
        <source>F is taken about the set-up centre: it contains the set-up error, which table A.1 does not expect of full circles.</source>
        <translation>F est rapporté au centre de réglage&#xa0;: il contient l’erreur de réglage, que le tableau A.1 ne prévoit pas pour des cercles complets.</translation>
    </message>
    <message>
        <source>The path %1 has no minimum zone circles: they need four different points that do not lie on a straight line.</source>
        <translation>La trajectoire %1 n’a pas de cercles de zone minimale&#xa0;: il y faut quatre points différents non alignés.</translation>
    </message>
    <message>
        <source>The minimum zone circles are not proven to be the narrowest.</source>
        <translation>Il n’est pas prouvé que les cercles de zone minimale sont les plus étroits.</translation>
    </message>
    <message>
        <source>The plane %1 is not XY, YZ or ZX: seen from the positive end of the third axis its senses are exchanged.</source>
        <translation>Le plan %1 n’est ni XY, ni YZ, ni ZX&#xa0;: vus de l’extrémité positive du troisième axe, ses sens sont inversés.</translation>
    </message>
    <message>
        <source>No value for F and D: the reference length is not calibrated.</source>
        <translation>Pas de valeur pour F et D&#xa0;: la longueur de référence n’est pas étalonnée.</translation>
    </message>
    <message>
        <source>F and D need a calibrated reference length: whether it is calibrated is not stated.</source>
        <translation>F et D demandent une longueur de référence étalonnée&#xa0;: il n’est pas indiqué si elle l’est.</translation>
    </message>
    <message>
        <source>F and D are not corrected to 20 °C, and the test was made at another temperature.</source>
        <translation>F et D ne sont pas ramenés à 20&#xa0;°C, et l’essai a été fait à une autre température.</translation>
    </message>
    <message>
        <source>F and D cannot be corrected to 20 °C: temperatures at start and end and the coefficients of thermal expansion of machine and instrument are needed.</source>
        <translation>F et D ne peuvent pas être ramenés à 20&#xa0;°C&#xa0;: il y faut les températures au début et à la fin et les coefficients de dilatation thermique de la machine et de l’instrument.</translation>
    </message>
    <message>
        <source>The instrument was centred anew between the runs.</source>
        <translation>L’instrument a été recentré entre les parcours.</translation>
    </message>
    <message>
        <source>Feedback signal: the annex speaks of machines with linear scales; what lies between scale and tool is not seen.</source>
        <translation>Signal de retour&#xa0;: l’annexe parle de machines à règles de mesure linéaires&#x202f;; ce qui se trouve entre la règle et l’outil n’est pas vu.</translation>
    </message>
    <message>
        <source>F and D cannot be had from a feedback signal.</source>
        <translation>F et D ne peuvent pas être tirés d’un signal de retour.</translation>
    </message>
    <message>
        <source>bi-directional circular deviation</source>
        <translation>écart de circularité bidirectionnel</translation>
    </message>
    <message>
        <source>mean bi-directional radial deviation</source>
        <translation>écart radial moyen bidirectionnel</translation>
    </message>
    <message>
        <source>circular deviation</source>
        <translation>écart de circularité</translation>
    </message>
    <message>
        <source>radial deviation, maximum</source>
        <translation>écart radial, maximum</translation>
    </message>
    <message>
        <source>radial deviation, minimum</source>
        <translation>écart radial, minimum</translation>
    </message>
    <message>
        <source>bi-directional circular deviation using feed back signal</source>
        <translation>écart de circularité bidirectionnel par signal de retour</translation>
    </message>
    <message>
        <source>circular deviation using feed back signal</source>
        <translation>écart de circularité par signal de retour</translation>
    </message>
    <message>
        <source>bi-directional circular error</source>
        <translation>erreur de circularité bidirectionnelle</translation>
    </message>
    <message>
        <source>mean bi-directional radial error</source>
        <translation>erreur radiale moyenne bidirectionnelle</translation>
    </message>
    <message>
        <source>circular error</source>
        <translation>erreur de circularité</translation>
    </message>
    <message>
        <source>radial error, maximum</source>
        <translation>erreur radiale, maximum</translation>
    </message>
    <message>
        <source>radial error, minimum</source>
        <translation>erreur radiale, minimum</translation>
    </message>
    <message>
        <source>bi-directional circular error using feed back signal</source>
        <translation>erreur de circularité bidirectionnelle par signal de retour</translation>
    </message>
    <message>
        <source>circular error using feed back signal</source>
        <translation>erreur de circularité par signal de retour</translation>
    </message>
    <message>
        <source>circular hysteresis</source>
        <translation>hystérésis circulaire</translation>
    </message>
    <message>
        <source>axes moved</source>
        <translation>axes en mouvement</translation>
    </message>
    <message>
        <source>contouring feed</source>
        <translation>vitesse d’avance de contournage</translation>
    </message>
    <message>
        <source>location of the instrument: centre of the circle</source>
        <translation>position de l’instrument&#xa0;: centre du cercle</translation>
    </message>
    <message>
        <source>location of the instrument: offset to the tool reference</source>
        <translation>position de l’instrument&#xa0;: décalage par rapport à la référence de l’outil</translation>
    </message>
    <message>
        <source>location of the instrument: offset to the workpiece reference</source>
        <translation>position de l’instrument&#xa0;: décalage par rapport à la référence de la pièce</translation>
    </message>
    <message>
        <source>correction of F and D to 20 °C</source>
        <translation>correction de F et D à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>start point</source>
        <translation>point de départ</translation>
    </message>
    <message>
        <source>stop point</source>
        <translation>point d’arrivée</translation>
    </message>
    <message>
        <source>data smoothing</source>
        <translation>lissage des données</translation>
    </message>
    <message>
        <source>measured one after the other without re-centring</source>
        <translation>mesures successives sans recentrage</translation>
    </message>
    <message>
        <source>compensation active during the test</source>
        <translation>compensation active pendant l’essai</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>dates</comment>
        <translation>du %1 au %2</translation>
    </message>
    <message>
        <source>control %1</source>
        <translation>commande %1</translation>
    </message>
    <message>
        <source>year %1</source>
        <translation>année %1</translation>
    </message>
    <message>
        <source>self-test not run</source>
        <translation>autocontrôle non exécuté</translation>
    </message>
    <message>
        <source>self-test against published data passed</source>
        <translation>autocontrôle sur des données publiées réussi</translation>
    </message>
    <message>
        <source>self-test against published data NOT passed</source>
        <translation>autocontrôle sur des données publiées NON réussi</translation>
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
        <source>Supplier/manufacturer</source>
        <translation>Fournisseur/constructeur</translation>
    </message>
    <message>
        <source>Customer/user</source>
        <translation>Client/utilisateur</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numéro de série</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificat</translation>
    </message>
    <message>
        <source>Calibrated by</source>
        <translation>Étalonné par</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>Étalonné le</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>Échéance</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source>Traceability of the instruments</source>
        <translation>Traçabilité des instruments</translation>
    </message>
    <message>
        <source>range of the deviations %1</source>
        <translation>étendue des écarts %1</translation>
    </message>
    <message>
        <source>Drift tests</source>
        <translation>Essais de dérive</translation>
    </message>
    <message>
        <source>environmental variation error</source>
        <translation>erreur de variation environnementale</translation>
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
        <source>Tests carried out</source>
        <translation>Essais exécutés</translation>
    </message>
    <message>
        <source>Details of the machine</source>
        <translation>Précisions sur la machine</translation>
    </message>
    <message>
        <source>Condition of the machine</source>
        <translation>État de la machine</translation>
    </message>
    <message>
        <source>Adjustments made</source>
        <translation>Réglages effectués</translation>
    </message>
    <message>
        <source>replaces %1</source>
        <translation>remplace %1</translation>
    </message>
    <message>
        <source>Revision</source>
        <translation>Révision</translation>
    </message>
    <message>
        <source>Authorised by</source>
        <translation>Autorisé par</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Fingerprint SHA-256</source>
        <translation>Empreinte SHA-256</translation>
    </message>
    <message>
        <source>Statements</source>
        <translation>Mentions</translation>
    </message>
    <message>
        <source>The results relate only to the machine tested in the stated condition.</source>
        <translation>Les résultats ne se rapportent qu’à la machine soumise à l’essai, dans l’état indiqué.</translation>
    </message>
    <message>
        <source>This report may be reproduced only in full.</source>
        <translation>Ce rapport ne peut être reproduit que dans son intégralité.</translation>
    </message>
    <message>
        <source>The fingerprint is that of the test file this report was made from.</source>
        <translation>L’empreinte est celle du fichier d’essai dont ce rapport est issu.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Signature</translation>
    </message>
    <message>
        <source>Signatures</source>
        <translation>Signatures</translation>
    </message>
    <message>
        <source>End of the report</source>
        <translation>Fin du rapport</translation>
    </message>
    <message>
        <source>Results for the %1 axis</source>
        <translation>Résultats de l’axe %1</translation>
    </message>
    <message>
        <source>Report %1</source>
        <translation>Rapport %1</translation>
    </message>
    <message>
        <source>Fingerprint SHA-256 %1</source>
        <translation>Empreinte SHA-256 %1</translation>
    </message>
    <message>
        <source>page %1 / %2</source>
        <translation>page %1 / %2</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>agreed or maker’s procedure</source>
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
        <source>chosen freely</source>
        <translation>choix libre</translation>
    </message>
    <message>
        <source>faces of the polygon</source>
        <translation>faces du polygone</translation>
    </message>
    <message>
        <source>fixed by the instrument</source>
        <translation>imposés par l’instrument</translation>
    </message>
    <message>
        <source>nominal interval %1</source>
        <translation>intervalle nominal %1</translation>
    </message>
    <message>
        <source>period %1</source>
        <translation>période %1</translation>
    </message>
    <message>
        <source>random part of seed %1</source>
        <translation>part aléatoire de germe %1</translation>
    </message>
    <message>
        <source>tool offset: %1</source>
        <translation>décalage d’outil&#xa0;: %1</translation>
    </message>
    <message>
        <source>workpiece offset: %1</source>
        <translation>décalage de pièce&#xa0;: %1</translation>
    </message>
    <message>
        <source>Warm-up</source>
        <translation>Mise en température</translation>
    </message>
    <message>
        <source>rapid feed</source>
        <translation>vitesse rapide</translation>
    </message>
    <message>
        <source>Feed between targets</source>
        <translation>Avance entre points</translation>
    </message>
    <message>
        <source>Dwell at target</source>
        <translation>Arrêt au point visé</translation>
    </message>
    <message>
        <source>Approach distance</source>
        <translation>Distance d’approche</translation>
    </message>
    <message>
        <source>machine unloaded</source>
        <comment>1988</comment>
        <translation>machine non chargée</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>machine loaded</source>
        <translation>machine chargée</translation>
    </message>
    <message>
        <source>State of the machine</source>
        <translation>État de la machine</translation>
    </message>
    <message>
        <source>complete and in working order</source>
        <translation>complète et en état de marche</translation>
    </message>
    <message>
        <source>not complete</source>
        <translation>incomplète</translation>
    </message>
    <message>
        <source>levelled and aligned</source>
        <translation>mise à niveau et alignée</translation>
    </message>
    <message>
        <source>not levelled</source>
        <translation>non mise à niveau</translation>
    </message>
    <message>
        <source>Active compensation</source>
        <translation>Compensation active</translation>
    </message>
    <message>
        <source>Other axes</source>
        <translation>Autres axes</translation>
    </message>
    <message>
        <source>Measuring line</source>
        <translation>Ligne de mesurage</translation>
    </message>
    <message>
        <source>Choice of targets</source>
        <translation>Choix des points</translation>
    </message>
    <message>
        <source>Target positions</source>
        <translation>Points visés</translation>
    </message>
    <message>
        <source>Zero of displacement</source>
        <translation>Zéro du déplacement</translation>
    </message>
    <message>
        <source>Soak</source>
        <translation>Stabilisation thermique</translation>
    </message>
    <message>
        <source>Thermal shielding</source>
        <translation>Protection thermique</translation>
    </message>
    <message>
        <source>Maker’s thermal guidelines</source>
        <translation>Recommandations thermiques du constructeur</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Air</translation>
    </message>
    <message>
        <source>Environment</source>
        <comment>1988</comment>
        <translation>Environnement d’essai</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Environnement</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
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
        <source>α machine</source>
        <translation>α de la machine</translation>
    </message>
    <message>
        <source>α instrument</source>
        <translation>α de l’instrument</translation>
    </message>
    <message>
        <source>Temperature of</source>
        <translation>Température de</translation>
    </message>
    <message>
        <source>Position of the sensor</source>
        <translation>Position du capteur</translation>
    </message>
    <message>
        <source>Temperature sensors</source>
        <translation>Capteurs de température</translation>
    </message>
    <message>
        <source>Test conditions</source>
        <translation>Conditions d’essai</translation>
    </message>
    <message>
        <source>Nominal differential expansion (NDE): %1.</source>
        <translation>Dilatation différentielle nominale (DDN)&#xa0;: %1.</translation>
    </message>
    <message>
        <source>between supplier/manufacturer and user</source>
        <comment>1988</comment>
        <translation>entre le fournisseur et le client</translation>
    </message>
    <message>
        <source>between supplier/manufacturer and user</source>
        <translation>entre le fournisseur/constructeur et l’utilisateur</translation>
    </message>
    <message>
        <source>%1, clause %2</source>
        <translation>%1, article %2</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation>Accord</translation>
    </message>
    <message>
        <source>Agreed text</source>
        <translation>Texte convenu</translation>
    </message>
    <message>
        <source>agreed</source>
        <translation>convenu</translation>
    </message>
    <message>
        <source>not agreed</source>
        <translation>non convenu</translation>
    </message>
    <message>
        <source>not applicable</source>
        <translation>sans objet</translation>
    </message>
    <message>
        <source>Points to be agreed</source>
        <translation>Points soumis à accord</translation>
    </message>
    <message>
        <source>Measurement uncertainty</source>
        <translation>Incertitude de mesure</translation>
    </message>
    <message>
        <source>The expanded uncertainties U beside the results were stated by the laboratory.</source>
        <translation>Les incertitudes étendues U indiquées avec les résultats ont été données par le laboratoire.</translation>
    </message>
    <message>
        <source>%1 asks for the uncertainty beside every result; some are not stated.</source>
        <translation>L’édition %1 demande l’incertitude de chaque résultat&#x202f;; certaines ne sont pas indiquées.</translation>
    </message>
    <message>
        <source>%1 asks for the uncertainty beside every result; none is stated.</source>
        <translation>L’édition %1 demande l’incertitude de chaque résultat&#x202f;; aucune n’est indiquée.</translation>
    </message>
    <message>
        <source>Whether the readings are corrected to 20 °C is not stated; nothing is corrected here.</source>
        <translation>Il n’est pas indiqué si les relevés sont corrigés à 20&#xa0;°C&#x202f;; rien n’est corrigé ici.</translation>
    </message>
    <message>
        <source>The readings are not corrected to 20 °C.</source>
        <translation>Les relevés ne sont pas corrigés à 20&#xa0;°C.</translation>
    </message>
    <message>
        <source>The material compensation of the instrument was on: the readings hold at 20 °C, nothing is corrected here.</source>
        <translation>La compensation de matériau de l’instrument était active&#xa0;: les relevés valent pour 20&#xa0;°C, rien n’est corrigé ici.</translation>
    </message>
    <message>
        <source>The correction was to be made here, but temperatures or coefficients of expansion are missing: nothing is corrected.</source>
        <translation>La correction devait être faite ici, mais il manque des températures ou des coefficients de dilatation&#xa0;: rien n’est corrigé.</translation>
    </message>
    <message>
        <source>Made here for the expansion of the machine (α = %1, θ = %2); the instrument compensates the air only.</source>
        <translation>Faite ici pour la dilatation de la machine (α = %1, θ = %2)&#x202f;; l’instrument ne compense que l’air.</translation>
    </message>
    <message>
        <source>Made here for the expansion of the machine (α = %1, θ = %2) and of the instrument (α = %3, θ = %4).</source>
        <translation>Faite ici pour la dilatation de la machine (α = %1, θ = %2) et de l’instrument (α = %3, θ = %4).</translation>
    </message>
    <message>
        <source>nominal differential expansion (NDE)</source>
        <translation>dilatation différentielle nominale (DDN)</translation>
    </message>
    <message>
        <source>Added to the readings</source>
        <translation>Ajouté aux relevés</translation>
    </message>
    <message>
        <source>factor %1</source>
        <translation>facteur %1</translation>
    </message>
    <message>
        <source>Results per target position</source>
        <translation>Résultats par point visé</translation>
    </message>
    <message>
        <source>factor %1; bold: the value that rules the parameter of the axis</source>
        <translation>facteur %1&#x202f;; en gras la valeur qui gouverne le paramètre de l’axe</translation>
    </message>
    <message>
        <source>positioning deviations</source>
        <translation>écarts de position</translation>
    </message>
    <message>
        <source>positional deviations</source>
        <translation>écarts de position</translation>
    </message>
    <message>
        <source>as read, without the correction to 20 °C</source>
        <translation>tels que relevés, sans la correction à 20&#xa0;°C</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Relevés</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Excluded readings</source>
        <translation>Relevés écartés</translation>
    </message>
    <message>
        <source>set aside: they have no part in the results</source>
        <translation>ils ne sont pas pris en compte dans les résultats</translation>
    </message>
    <message>
        <source>Comparison of editions</source>
        <translation>Comparaison des éditions</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Result stated by the instrument’s program</source>
        <translation>Résultat donné par le programme de l’instrument</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Origin of the data</source>
        <translation>Origine des données</translation>
    </message>
    <message>
        <source>Largest at target %1, smallest at target %2.</source>
        <translation>Maximum au point visé %1, minimum au point visé %2.</translation>
    </message>
    <message>
        <source>Target %1 rules it.</source>
        <translation>Imposé par le point visé %1.</translation>
    </message>
    <message>
        <source>Mean over %1 targets: none rules it alone.</source>
        <translation>Moyenne sur %1 points visés&#xa0;: aucun ne l’impose seul.</translation>
    </message>
    <message>
        <source>s by the range method: s = W / k(n).</source>
        <translation>s par la méthode de l’étendue&#xa0;: s = W / k(n).</translation>
    </message>
    <message>
        <source>With the correction to 20 °C applied here.</source>
        <translation>Avec la correction à 20&#xa0;°C appliquée ici.</translation>
    </message>
    <message>
        <source>Not corrected to 20 °C.</source>
        <translation>Non corrigé à 20&#xa0;°C.</translation>
    </message>
    <message>
        <source>The scatter of one direction alone is the largest form.</source>
        <translation>La dispersion d’un seul sens est la plus grande des trois formes.</translation>
    </message>
    <message>
        <source>What weighs: |B| %1 (%2), %3 %4 (%5), %6 %7 (%8).</source>
        <translation>Ce qui pèse&#xa0;: |B| %1 (%2), %3 %4 (%5), %6 %7 (%8).</translation>
    </message>
    <message>
        <source>%1, clauses %2 and %3</source>
        <translation>%1, articles %2 et %3</translation>
    </message>
    <message>
        <source>Report No. %1</source>
        <translation>Rapport n° %1</translation>
    </message>
    <message>
        <source>revision %1</source>
        <translation>révision %1</translation>
    </message>
    <message>
        <source>issued %1</source>
        <translation>émis le %1</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lieu</translation>
    </message>
    <message>
        <source>Supplier</source>
        <translation>Fournisseur</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Client</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>n° %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>certificate, date</comment>
        <translation>%1 du %2</translation>
    </message>
    <message>
        <source>m = %1; n = %2 %3</source>
        <translation>m = %1&#x202f;; n = %2 %3</translation>
    </message>
    <message>
        <source>m = %1; n = %2 per direction</source>
        <translation>m = %1&#x202f;; n = %2 par sens</translation>
    </message>
    <message>
        <source>Acceptance test report</source>
        <translation>Rapport d’essai de réception</translation>
    </message>
    <message>
        <source>Test %1 of %2</source>
        <translation>Essai %1 de %2</translation>
    </message>
    <message>
        <source>Measurement travel</source>
        <translation>Course de mesurage</translation>
    </message>
    <message>
        <source>Measuring system</source>
        <translation>Système de mesure</translation>
    </message>
    <message>
        <source>Summary of the tests</source>
        <translation>Récapitulation des essais</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Commande numérique</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>no limit agreed</source>
        <translation>aucune limite convenue</translation>
    </message>
    <message>
        <source>NOT in accordance with the edition</source>
        <translation>essai NON conforme à l’édition</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Verdict of the report</source>
        <translation>Verdict du rapport</translation>
    </message>
    <message>
        <source>The worst verdict of the tests.</source>
        <translation>Le plus défavorable des verdicts des essais.</translation>
    </message>
    <message>
        <source>No limit was agreed: the results have no verdict.</source>
        <translation>Aucune limite n’a été convenue&#xa0;: les résultats sont sans verdict.</translation>
    </message>
    <message>
        <source>All tests carried out in accordance with their editions.</source>
        <translation>Tous les essais ont été exécutés conformément à leur édition.</translation>
    </message>
    <message>
        <source>Tests NOT in accordance with their edition: %1 of %2.</source>
        <translation>Essais NON conformes à leur édition&#xa0;: %1 sur %2.</translation>
    </message>
    <message>
        <source>%1 readings: mean %2, range %3</source>
        <translation>%1 relevés&#xa0;: moyenne %2, étendue %3</translation>
    </message>
    <message>
        <source>of an axis</source>
        <comment>end of the name of a parameter</comment>
        <translation>d’un axe</translation>
    </message>
    <message>
        <source>Targets</source>
        <comment>followed by i</comment>
        <translation>Points</translation>
    </message>
    <message>
        <source>Limit ± U</source>
        <translation>Limite ± U</translation>
    </message>
    <message>
        <source>Limit ± g</source>
        <translation>Limite ± g</translation>
    </message>
    <message>
        <source>ISO 14253-1, conformity has to be proven</source>
        <translation>ISO 14253-1, conformité à prouver</translation>
    </message>
    <message>
        <source>non-conformity has to be proven</source>
        <translation>non-conformité à prouver</translation>
    </message>
    <message>
        <source>s by the range method</source>
        <translation>s par la méthode de l’étendue</translation>
    </message>
    <message>
        <source>s by the calculation method</source>
        <translation>s par la méthode de calcul</translation>
    </message>
    <message>
        <source>verdict taken from the unrounded values</source>
        <translation>verdict pris sur les valeurs non arrondies</translation>
    </message>
    <message>
        <source>value</source>
        <comment>legend</comment>
        <translation>valeur</translation>
    </message>
    <message>
        <source>limit. Value left of the limit: conforms; right of it: does not conform.</source>
        <translation>limite. Valeur à gauche de la limite&#xa0;: conforme&#x202f;; à droite&#xa0;: non conforme.</translation>
    </message>
    <message>
        <source>limit</source>
        <comment>legend</comment>
        <translation>limite</translation>
    </message>
    <message>
        <source>limit ± %1. Value left of the band: conforms; within: non-conformity not proven; right: does not conform.</source>
        <translation>limite ± %1. À gauche de la bande&#xa0;: conforme&#x202f;; dedans&#xa0;: non-conformité non démontrée&#x202f;; à droite&#xa0;: non conforme.</translation>
    </message>
    <message>
        <source>limit ± %1. Value left of the band: conforms; in the band: not proven; right of the band: does not conform.</source>
        <translation>limite ± %1. Valeur à gauche de la bande&#xa0;: conforme&#x202f;; dans la bande&#xa0;: non prouvé&#x202f;; à droite&#xa0;: non conforme.</translation>
    </message>
    <message>
        <source>%1 (%2 against %3)</source>
        <translation>%1 (%2 pour %3)</translation>
    </message>
    <message>
        <source>Limits exceeded by more than the guard band: %1.</source>
        <translation>Limites dépassées de plus que la bande de garde&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Limits exceeded: %1.</source>
        <translation>Limites dépassées&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 exceeds its limit: %2 against %3.</source>
        <translation>%1 dépasse sa limite&#xa0;: %2 pour %3.</translation>
    </message>
    <message>
        <source>%1 exceeds its limit by more than the uncertainty: %2 against %3 + %4 = %5.</source>
        <translation>%1 dépasse sa limite de plus que l’incertitude&#xa0;: %2 pour %3 + %4 = %5.</translation>
    </message>
    <message>
        <source>%1 exceeds its limit by more than the guard band: %2 against %3 + %4 = %5.</source>
        <translation>%1 dépasse sa limite de plus que la bande de garde&#xa0;: %2 pour %3 + %4 = %5.</translation>
    </message>
    <message>
        <source>Not corrected to 20 °C, nothing is proven for %1.</source>
        <translation>Sans correction à 20&#xa0;°C, rien n’est prouvé pour %1.</translation>
    </message>
    <message>
        <source>Without the measurement uncertainty nothing is proven for %1.</source>
        <translation>Sans l’incertitude de mesure, rien n’est prouvé pour %1.</translation>
    </message>
    <message>
        <source>For %1 non-conformity not proven: may not be rejected.</source>
        <translation>Pour %1, non-conformité non démontrée&#xa0;: ne peut être refusé.</translation>
    </message>
    <message>
        <source>For %1 neither conformity nor non-conformity is proven.</source>
        <translation>Pour %1, ni la conformité ni la non-conformité n’est prouvée.</translation>
    </message>
    <message>
        <source>The limits agreed do not hold for this test: no verdict.</source>
        <translation>Les limites convenues ne valent pas pour cet essai&#xa0;: pas de verdict.</translation>
    </message>
    <message>
        <source>Within its limit: %1.</source>
        <translation>Limite respectée&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Others: no limit agreed.</source>
        <translation>Autres&#xa0;: pas de limite.</translation>
    </message>
    <message>
        <source>Verdict of the test</source>
        <translation>Verdict de l’essai</translation>
    </message>
    <message>
        <source>Test carried out in accordance with %1.</source>
        <translation>Essai exécuté conformément à %1.</translation>
    </message>
    <message numerus="yes">
        <source>Test NOT in accordance with %1: %n requirement(s) not met</source>
        <translation>
            <numerusform>Essai NON conforme à %1&#xa0;: %n exigence non satisfaite</numerusform>
            <numerusform>Essai NON conforme à %1&#xa0;: %n exigences non satisfaites</numerusform>
        </translation>
    </message>
    <message>
        <source>see page %1</source>
        <translation>voir page %1</translation>
    </message>
    <message>
        <source>means</source>
        <comment>figure</comment>
        <translation>moyennes</translation>
    </message>
    <message>
        <source>means and limits at ± %1s</source>
        <translation>moyennes et limites à ± %1s</translation>
    </message>
    <message>
        <source>bidirectional test</source>
        <translation>essai bidirectionnel</translation>
    </message>
    <message>
        <source>unidirectional test</source>
        <translation>essai unidirectionnel</translation>
    </message>
    <message>
        <source>what the edition asks for and this test does not have</source>
        <translation>ce que l’édition demande et que cet essai n’a pas</translation>
    </message>
    <message>
        <source>Limits and decision rule</source>
        <translation>Limites et règle de décision</translation>
    </message>
    <message>
        <source>Agreed for</source>
        <translation>Convenue pour</translation>
    </message>
    <message>
        <source>Source</source>
        <comment>of a limit</comment>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Simple acceptance: a value conforms when it is not above its limit; the uncertainty has no part in it.</source>
        <translation>Acceptation simple&#xa0;: une valeur est conforme lorsqu’elle ne dépasse pas sa limite&#x202f;; l’incertitude n’intervient pas.</translation>
    </message>
    <message>
        <source>ISO 14253-1, conformity has to be proven: a value conforms when it is at least g below its limit, does not conform when it is more than g above it, and is not proven between; g = %1·U.</source>
        <translation>ISO 14253-1, conformité à prouver&#xa0;: une valeur est conforme lorsqu’elle est inférieure à sa limite d’au moins g, non conforme lorsqu’elle la dépasse de plus de g, et non prouvée entre les deux&#x202f;; g = %1·U.</translation>
    </message>
    <message>
        <source>Non-conformity has to be proven: a value conforms when it is at least g below its limit and does not conform when it is more than g above it; between, non-conformity is not proven: may not be rejected; g = %1·U.</source>
        <translation>Non-conformité à prouver&#xa0;: une valeur est conforme lorsqu’elle est inférieure à sa limite d’au moins g et non conforme lorsqu’elle la dépasse de plus de g&#x202f;; entre les deux, non-conformité non démontrée&#xa0;: ne peut être refusé&#x202f;; g = %1·U.</translation>
    </message>
    <message>
        <source>The factor 1 is the guard band of the earlier editions of ISO 14253-1.</source>
        <translation>Le facteur 1 est la bande de garde des éditions antérieures de l’ISO 14253-1.</translation>
    </message>
    <message>
        <source>The factor 0.83 (1.65 u) is the later 95 % rule of ISO 14253-1 for one limit.</source>
        <translation>Le facteur 0,83 (1,65 u) est la règle à 95&#xa0;% des éditions ultérieures de l’ISO 14253-1 pour une seule limite.</translation>
    </message>
    <message>
        <source>Signed results are compared by their absolute value; the verdict is taken from the unrounded values.</source>
        <translation>Les résultats signés sont comparés par leur valeur absolue&#x202f;; le verdict est pris sur les valeurs non arrondies.</translation>
    </message>
    <message>
        <source>accuracy</source>
        <comment>1988</comment>
        <translation>précision</translation>
    </message>
    <message>
        <source>accuracy</source>
        <translation>exactitude</translation>
    </message>
    <message>
        <source>systematic deviation</source>
        <translation>écart systématique</translation>
    </message>
    <message>
        <source>systematic error</source>
        <translation>écart systématique</translation>
    </message>
    <message>
        <source>range of x̄</source>
        <translation>étendue de x̄</translation>
    </message>
    <message>
        <source>repeatability</source>
        <translation>répétabilité</translation>
    </message>
    <message>
        <source>reversal value</source>
        <translation>réversibilité</translation>
    </message>
    <message>
        <source>reversal error</source>
        <translation>réversibilité</translation>
    </message>
    <message>
        <source>mean reversal value</source>
        <comment>1988</comment>
        <translation>erreur moy. de réversibilité</translation>
    </message>
    <message>
        <source>signed mean</source>
        <translation>moyenne signée</translation>
    </message>
    <message>
        <source>unidirectional</source>
        <translation>unidirectionnelle</translation>
    </message>
    <message>
        <source>unidirectional</source>
        <comment>masculine</comment>
        <translation>unidirectionnel</translation>
    </message>
    <message>
        <source>smaller of R↑, R↓</source>
        <translation>min. de R↑ et R↓</translation>
    </message>
    <message>
        <source>positional uncertainty</source>
        <translation>incertitude de position</translation>
    </message>
    <message>
        <source>positional deviation</source>
        <comment>VDI</comment>
        <translation>écart de position</translation>
    </message>
    <message>
        <source>scatter, largest</source>
        <translation>dispersion maximale</translation>
    </message>
    <message>
        <source>scatter, mean</source>
        <translation>dispersion moyenne</translation>
    </message>
    <message>
        <source>reversal range, largest</source>
        <translation>réversibilité maximale</translation>
    </message>
    <message>
        <source>reversal range, mean</source>
        <translation>réversibilité moyenne</translation>
    </message>
    <message>
        <source>ISO 14253-1</source>
        <translation>ISO 14253-1</translation>
    </message>
    <message>
        <source>rejection proven</source>
        <translation>refus prouvé</translation>
    </message>
    <message>
        <source>Symbol</source>
        <translation>Symbole</translation>
    </message>
    <message>
        <source>ISO %1</source>
        <comment>after a preposition</comment>
        <translation>l’ISO %1</translation>
    </message>
    <message>
        <source>Positioning test of the %1 axis</source>
        <translation>Essai de positionnement de l’axe %1</translation>
    </message>
    <message>
        <source>Circular test in the %1 plane</source>
        <translation>Essai de circularité dans le plan %1</translation>
    </message>
    <message>
        <source>Drift test of the %1 axis</source>
        <translation>Essai de dérive de l’axe %1</translation>
    </message>
    <message>
        <source>the picture to write; its ending says what it is</source>
        <translation>l’image à écrire&#x202f;; son extension dit ce qu’elle est</translation>
    </message>
    <message>
        <source>which test of the file, from 1; without it the first</source>
        <translation>quel essai du fichier, à partir de 1&#x202f;; sans elle, le premier</translation>
    </message>
    <message>
        <source>which figure; without it that of the test</source>
        <translation>quelle figure&#x202f;; sans elle, celle de l’essai</translation>
    </message>
    <message>
        <source>there is no test %1; the file has %2</source>
        <translation>il n’y a pas d’essai %1&#x202f;; le fichier en a %2</translation>
    </message>
    <message>
        <source>the command %1 needs a file to write (%2)</source>
        <translation>la commande %1 a besoin d’un fichier à écrire (%2)</translation>
    </message>
    <message>
        <source>the command %1 takes one file</source>
        <translation>la commande %1 prend un seul fichier</translation>
    </message>
    <message>
        <source>unknown figure %1; known: %2</source>
        <translation>figure %1 inconnue&#x202f;; connues&#xa0;: %2</translation>
    </message>
    <message>
        <source>the test %1 has no figure %2</source>
        <translation>l’essai %1 n’a pas de figure %2</translation>
    </message>
    <message>
        <source>one figure as a picture</source>
        <translation>une figure comme image</translation>
    </message>
    <message>
        <source>the PDF to write; of two languages OUT.fr.pdf and OUT.en.pdf</source>
        <translation>le PDF à écrire&#x202f;; pour deux langues OUT.fr.pdf et OUT.en.pdf</translation>
    </message>
    <message>
        <source>language of the report; without it those the file asks for</source>
        <translation>langue du rapport&#x202f;; sans elle, celles que le fichier demande</translation>
    </message>
    <message>
        <source>standard output takes one report; choose --language</source>
        <translation>la sortie standard prend un seul rapport&#x202f;; choisir --language</translation>
    </message>
    <message>
        <source>the printed report as PDF</source>
        <translation>le rapport imprimé en PDF</translation>
    </message>
    <message>
        <source>The limits agreed do not hold for these tests: no verdict.</source>
        <translation>Les limites convenues ne valent pas pour ces essais&#xa0;: pas de verdict.</translation>
    </message>
    <message>
        <source>no verdict</source>
        <translation>pas de verdict</translation>
    </message>
    <message>
        <source>Worked example of ISO 230-2:1988 (table 2): the position of the first target and ten readings are stand-ins with the published mean and s. Compare the mean reversal value (published: %1), R↑ (%2), R↓ (%3), R (%4), A (%5) and the values per target, never the single readings.</source>
        <translation>Exemple traité de l’ISO 230-2:1988 (tableau 2)&#xa0;: la position du premier point visé et dix relevés sont des valeurs de remplacement ayant la moyenne et le s publiés. Comparer l’erreur moyenne de réversibilité (publiée&#xa0;: %1), R↑ (%2), R↓ (%3), R (%4), A (%5) et les valeurs par point visé, jamais les relevés isolés.</translation>
    </message>
    <message>
        <source>Nominal radius</source>
        <translation>Rayon nominal</translation>
    </message>
    <message>
        <source>Contouring feed</source>
        <translation>Vitesse d’avance de contournage</translation>
    </message>
    <message>
        <source>Reference circle</source>
        <translation>Cercle de référence</translation>
    </message>
    <message>
        <source>minimum zone circles (MZC)</source>
        <translation>cercles de zone minimale (MZC)</translation>
    </message>
    <message>
        <source>least squares circle (LSC)</source>
        <translation>cercle des moindres carrés (LSC)</translation>
    </message>
    <message>
        <source>anticlockwise</source>
        <translation>sens antihoraire</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>sens horaire</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajectoire</translation>
    </message>
    <message>
        <source>%1, %2: %3 points evaluated from %4 to %5</source>
        <translation>%1, %2&#xa0;: %3 points évalués de %4 à %5</translation>
    </message>
    <message>
        <source>Correction of F and D to 20 °C</source>
        <translation>Correction de F et D à 20&#xa0;°C</translation>
    </message>
</context>
</TS>
