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
        <source>Worked example of ISO 230-2:1988 (table 2): the position of the first target and ten readings are stand-ins with the published mean and s. Compare the mean reversal value, R, A and the values per target, never the single readings.</source>
        <translation>Exemple traité de l’ISO 230-2:1988 (tableau 2)&#xa0;: la position du premier point visé et dix relevés sont des valeurs de remplacement ayant la moyenne et le s publiés. Comparer l’erreur moyenne de réversibilité, R, A et les valeurs par point visé, jamais les relevés isolés.</translation>
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
        <source>%1, clause %2</source>
        <translation>%1, article %2</translation>
    </message>
    <message>
        <source>%1, clauses %2 and %3</source>
        <translation>%1, articles %2 et %3</translation>
    </message>
    <message>
        <source>%1 readings: mean %2, range %3</source>
        <translation>%1 relevés&#xa0;: moyenne %2, étendue %3</translation>
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
</context>
</TS>
