; SPDX-FileCopyrightText: 2026 the Palmer authors
; SPDX-License-Identifier: GPL-3.0-or-later
; The installer: for one user, without rights of an administrator. Called by packaging/windows/build.
Target amd64-unicode
!include MUI2.nsh

Name "Palmer ${VERSION}"
OutFile "${OUTPUT}"
RequestExecutionLevel user
InstallDir "$LOCALAPPDATA\Programs\Palmer"
InstallDirRegKey HKCU "Software\Palmer" "Folder"
SetCompressor /SOLID lzma
ManifestDPIAware true

!define REGISTERED "Software\Microsoft\Windows\CurrentVersion\Uninstall\Palmer"
!define MUI_ICON "resources/windows/palmer.ico"
!define MUI_UNICON "resources/windows/palmer.ico"
!define MUI_FINISHPAGE_RUN "$INSTDIR\palmer.exe"
!define MUI_LANGDLL_ALLLANGUAGES
!insertmacro MUI_PAGE_LICENSE "LICENSE"
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!insertmacro MUI_PAGE_FINISH
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE "English"
!insertmacro MUI_LANGUAGE "French"
!insertmacro MUI_RESERVEFILE_LANGDLL

LangString KindOfFile ${LANG_ENGLISH} "Test of a machine tool"
LangString KindOfFile ${LANG_FRENCH} "Essai de machine-outil"
LangString Running ${LANG_ENGLISH} "Palmer is open. Close its windows, then try again."
LangString Running ${LANG_FRENCH} "Palmer est ouvert. Fermez ses fenêtres, puis réessayez."

Function .onInit
    !insertmacro MUI_LANGDLL_DISPLAY
FunctionEnd

Function un.onInit
    !insertmacro MUI_UNGETLANGUAGE
FunctionEnd

; Explorer reads the kinds of files anew.
!macro TellExplorer
    System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)'
!macroend

; A program that runs cannot be replaced.
!macro RequireClosed
    ClearErrors
    ${If} ${FileExists} "$INSTDIR\palmer.exe"
        FileOpen $0 "$INSTDIR\palmer.exe" a
        ${If} ${Errors}
            MessageBox MB_OK|MB_ICONEXCLAMATION "$(Running)" /SD IDOK
            SetErrorLevel 2
            Quit
        ${EndIf}
        FileClose $0
    ${EndIf}
!macroend

Section
    !insertmacro RequireClosed
    SetOutPath "$INSTDIR"
    File /r "${TREE}\*"
    WriteUninstaller "$INSTDIR\uninstall.exe"
    CreateShortCut "$SMPROGRAMS\Palmer.lnk" "$INSTDIR\palmer.exe"

    WriteRegStr HKCU "Software\Palmer" "Folder" "$INSTDIR"
    WriteRegStr HKCU "Software\Classes\.palmer" "" "Palmer.Test"
    WriteRegStr HKCU "Software\Classes\Palmer.Test" "" "$(KindOfFile)"
    WriteRegStr HKCU "Software\Classes\Palmer.Test\DefaultIcon" "" "$INSTDIR\palmer.exe,0"
    WriteRegStr HKCU "Software\Classes\Palmer.Test\shell\open\command" "" '"$INSTDIR\palmer.exe" "%1"'
    !insertmacro TellExplorer

    WriteRegStr HKCU "${REGISTERED}" "DisplayName" "Palmer"
    WriteRegStr HKCU "${REGISTERED}" "DisplayVersion" "${VERSION}"
    WriteRegStr HKCU "${REGISTERED}" "DisplayIcon" "$INSTDIR\palmer.exe"
    WriteRegStr HKCU "${REGISTERED}" "InstallLocation" "$INSTDIR"
    WriteRegStr HKCU "${REGISTERED}" "UninstallString" '"$INSTDIR\uninstall.exe"'
    WriteRegStr HKCU "${REGISTERED}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
    WriteRegDWORD HKCU "${REGISTERED}" "NoModify" 1
    WriteRegDWORD HKCU "${REGISTERED}" "NoRepair" 1
SectionEnd

; Tests, settings and the register of the user stay.
Section "Uninstall"
    !insertmacro RequireClosed
    Delete "$SMPROGRAMS\Palmer.lnk"
    Delete "$INSTDIR\*.exe"
    Delete "$INSTDIR\*.md"
    Delete "$INSTDIR\*.txt"
    RMDir /r "$INSTDIR\doc"
    RMDir /r "$INSTDIR\examples"
    RMDir /r "$INSTDIR\licences"
    RMDir /r "$INSTDIR\schema"
    RMDir "$INSTDIR"
    ReadRegStr $0 HKCU "Software\Classes\.palmer" ""
    ${If} $0 == "Palmer.Test"
        DeleteRegKey HKCU "Software\Classes\.palmer"
    ${EndIf}
    DeleteRegKey HKCU "Software\Classes\Palmer.Test"
    DeleteRegKey HKCU "Software\Palmer"
    DeleteRegKey HKCU "${REGISTERED}"
    !insertmacro TellExplorer
SectionEnd
