<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>ControlText</name>
    <message numerus="yes">
        <source>%n other selected servo(s) will be switched in the same way.</source>
        <translation>
            <numerusform>%n other selected servo will be switched in the same way.</numerusform>
            <numerusform>%n other selected servos will be switched in the same way.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>EventText</name>
    <message numerus="yes">
        <source>Search ended after %1 s, %n servo(s) found</source>
        <translation>
            <numerusform>Search ended after %1 s, %n servo found</numerusform>
            <numerusform>Search ended after %1 s, %n servos found</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RestoreText</name>
    <message numerus="yes">
        <source>%n row(s) written and read back</source>
        <translation>
            <numerusform>%n row written and read back</numerusform>
            <numerusform>%n rows written and read back</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ServoTasks</name>
    <message numerus="yes">
        <source>%n setting(s) changed: %1</source>
        <translation>
            <numerusform>%n setting changed: %1</numerusform>
            <numerusform>%n settings changed: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n other servo(s) stay at %1 baud. A program that uses only one baud rate can no longer reach all servos.</source>
        <translation>
            <numerusform>%n other servo stays at %1 baud. A program that uses only one baud rate can no longer reach all servos.</numerusform>
            <numerusform>%n other servos stay at %1 baud. A program that uses only one baud rate can no longer reach all servos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n servo(s) run the new firmware.</source>
        <translation>
            <numerusform>%n servo runs the new firmware.</numerusform>
            <numerusform>%n servos run the new firmware.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n servo(s), one after the other: ID %1</source>
        <translation>
            <numerusform>%n servo: ID %1</numerusform>
            <numerusform>%n servos, one after the other: ID %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SnapshotRow</name>
    <message numerus="yes">
        <source>%n servo(s)</source>
        <translation>
            <numerusform>%n servo</numerusform>
            <numerusform>%n servos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>template, %n row(s)</source>
        <translation>
            <numerusform>template, %n row</numerusform>
            <numerusform>template, %n rows</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>UndoText</name>
    <message numerus="yes">
        <source>%n setting(s)</source>
        <translation>
            <numerusform>%n setting</numerusform>
            <numerusform>%n settings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>WriteQuestion</name>
    <message numerus="yes">
        <source>Write %n setting(s) that need confirmation?</source>
        <translation>
            <numerusform>Write %n setting that needs confirmation?</numerusform>
            <numerusform>Write %n settings that need confirmation?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cli</name>
    <message numerus="yes">
        <source>%n register(s) saved to %1</source>
        <translation>
            <numerusform>%n register saved to %1</numerusform>
            <numerusform>%n registers saved to %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) written to %1</source>
        <translation>
            <numerusform>%n row written to %1</numerusform>
            <numerusform>%n rows written to %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) sent to %1 from bench %2; the server is now up to date</source>
        <translation>
            <numerusform>%n row sent to %1 from bench %2; the server is now up to date</numerusform>
            <numerusform>%n rows sent to %1 from bench %2; the server is now up to date</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n change(s) abandoned</source>
        <translation>
            <numerusform>%n change abandoned</numerusform>
            <numerusform>%n changes abandoned</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n servo(s) found on %1 in %2 s</source>
        <translation>
            <numerusform>%n servo found on %1 in %2 s</numerusform>
            <numerusform>%n servos found on %1 in %2 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Servo %1, %2: %n register(s) saved to %3</source>
        <translation>
            <numerusform>Servo %1, %2: %n register saved to %3</numerusform>
            <numerusform>Servo %1, %2: %n registers saved to %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reading(s) in %1 s, %2 missed</source>
        <translation>
            <numerusform>%n reading in %1 s, %2 missed</numerusform>
            <numerusform>%n readings in %1 s, %2 missed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n register(s)</source>
        <translation>
            <numerusform>%n register</numerusform>
            <numerusform>%n registers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) skipped: %1</source>
        <translation>
            <numerusform>%n row skipped: %1</numerusform>
            <numerusform>%n rows skipped: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) skipped</source>
        <translation>
            <numerusform>%n row skipped</numerusform>
            <numerusform>%n rows skipped</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n servo(s) found in %1 s</source>
        <translation>
            <numerusform>%n servo found in %1 s</numerusform>
            <numerusform>%n servos found in %1 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n register(s) in the table</source>
        <translation>
            <numerusform>%n register in the table</numerusform>
            <numerusform>%n registers in the table</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Settings of %n servo(s) saved to %1 (ID %2)</source>
        <translation>
            <numerusform>Settings of %n servo saved to %1 (ID %2)</numerusform>
            <numerusform>Settings of %n servos saved to %1 (ID %2)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Press Enter to write offset and limits of %n joint(s).</source>
        <translation>
            <numerusform>Press Enter to write offset and limits of %n joint.</numerusform>
            <numerusform>Press Enter to write offset and limits of %n joints.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>text</name>
    <message numerus="yes">
        <source>%n byte(s) received after a query to all servos at %1 baud: %2</source>
        <translation>
            <numerusform>%n byte received after a query to all servos at %1 baud: %2</numerusform>
            <numerusform>%n bytes received after a query to all servos at %1 baud: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n servo(s) found at %1 baud (%2): ID %3</source>
        <translation>
            <numerusform>%n servo found at %1 baud (%2): ID %3</numerusform>
            <numerusform>%n servos found at %1 baud (%2): ID %3</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Nothing was received at any of the %n baud rate(s) tried.</source>
        <translation>
            <numerusform>Nothing was received at the %n baud rate tried.</numerusform>
            <numerusform>Nothing was received at any of the %n baud rates tried.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The replies to all %n test query(s) arrived undamaged.</source>
        <translation>
            <numerusform>The reply to %n test query arrived undamaged.</numerusform>
            <numerusform>The replies to all %n test queries arrived undamaged.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) changed with the firmware:</source>
        <translation>
            <numerusform>%n setting changed with the firmware:</numerusform>
            <numerusform>%n settings changed with the firmware:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ApplyDialog</name>
    <message numerus="yes">
        <source>%n row(s) skipped</source>
        <translation>
            <numerusform>%n row skipped</numerusform>
            <numerusform>%n rows skipped</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Write to %n servo(s)?</source>
        <translation>
            <numerusform>Write to %n servo?</numerusform>
            <numerusform>Write to %n servos?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ArmPage</name>
    <message numerus="yes">
        <source>Write offset and limits of %n joint(s)?</source>
        <translation>
            <numerusform>Write offset and limits of %n joint?</numerusform>
            <numerusform>Write offset and limits of %n joints?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) written and read back.</source>
        <translation>
            <numerusform>%n joint written and read back.</numerusform>
            <numerusform>%n joints written and read back.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) reached both ends.</source>
        <translation>
            <numerusform>%n joint reached both ends.</numerusform>
            <numerusform>%n joints reached both ends.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Test %n joint(s)…</source>
        <translation>
            <numerusform>Test %n joint…</numerusform>
            <numerusform>Test %n joints…</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Record %n joint(s)…</source>
        <translation>
            <numerusform>Record %n joint…</numerusform>
            <numerusform>Record %n joints…</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stopped after %n joint(s), which reached both ends.</source>
        <translation>
            <numerusform>Stopped after %n joint, which reached both ends.</numerusform>
            <numerusform>Stopped after %n joints, which reached both ends.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::CommissionBatchView</name>
    <message numerus="yes">
        <source>%1 (%n ID(s))</source>
        <translation>
            <numerusform>%1 (%n ID)</numerusform>
            <numerusform>%1 (%n IDs)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::FindServosDialog</name>
    <message numerus="yes">
        <source>%n servo(s) · %1 · %2 baud</source>
        <translation>
            <numerusform>%n servo · %1 · %2 baud</numerusform>
            <numerusform>%n servos · %1 · %2 baud</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::FirmwarePage</name>
    <message numerus="yes">
        <source>All %n servo(s) run firmware %1.</source>
        <translation>
            <numerusform>The %n servo runs firmware %1.</numerusform>
            <numerusform>All %n servos run firmware %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::HistoryPage</name>
    <message numerus="yes">
        <source>%Ln row(s)</source>
        <translation>
            <numerusform>%Ln row</numerusform>
            <numerusform>%Ln rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln or more rows</source>
        <translation>
            <numerusform>%Ln or more rows</numerusform>
            <numerusform>%Ln or more rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) saved: %1</source>
        <translation>
            <numerusform>%Ln row saved: %1</numerusform>
            <numerusform>%Ln rows saved: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::HistorySendLabel</name>
    <message numerus="yes">
        <source>Sending %Ln row(s) to %1</source>
        <translation>
            <numerusform>Sending %Ln row to %1</numerusform>
            <numerusform>Sending %Ln rows to %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::OperateStatus</name>
    <message numerus="yes">
        <source>First seen at %1 · %n occurrence(s)</source>
        <translation>
            <numerusform>First seen at %1 · %n occurrence</numerusform>
            <numerusform>First seen at %1 · %n occurrences</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::RecordingControl</name>
    <message numerus="yes">
        <source>%1 · %Ln row(s)</source>
        <comment>time</comment>
        <translation>
            <numerusform>%1 · %Ln row</numerusform>
            <numerusform>%1 · %Ln rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) saved in %1. %2</source>
        <translation>
            <numerusform>%Ln row saved in %1. %2</numerusform>
            <numerusform>%Ln rows saved in %1. %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) recorded in %1</source>
        <translation>
            <numerusform>%Ln row recorded in %1</numerusform>
            <numerusform>%Ln rows recorded in %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) could not be stored because the disk was too slow.</source>
        <translation>
            <numerusform>%Ln row could not be stored because the disk was too slow.</numerusform>
            <numerusform>%Ln rows could not be stored because the disk was too slow.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::RestorePanel</name>
    <message numerus="yes">
        <source>Write %n selected row(s)</source>
        <translation>
            <numerusform>Write %n selected row</numerusform>
            <numerusform>Write %n selected rows</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::RunListDialog</name>
    <message numerus="yes">
        <source>Delete %n test(s)?</source>
        <translation>
            <numerusform>Delete %n test?</numerusform>
            <numerusform>Delete %n tests?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::SearchPanel</name>
    <message numerus="yes">
        <source>%1 % · %n servo(s) · %2 left</source>
        <translation>
            <numerusform>%1 % · %n servo · %2 left</numerusform>
            <numerusform>%1 % · %n servos · %2 left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stopped after %1 · %n servo(s)</source>
        <translation>
            <numerusform>Stopped after %1 · %n servo</numerusform>
            <numerusform>Stopped after %1 · %n servos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Search took %1 · %n servo(s)</source>
        <translation>
            <numerusform>Search took %1 · %n servo</numerusform>
            <numerusform>Search took %1 · %n servos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n ID(s) to search</source>
        <translation>
            <numerusform>%n ID to search</numerusform>
            <numerusform>%n IDs to search</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::SelfTest</name>
    <message numerus="yes">
        <source>ServoDesk works: %n step(s) in %1 s.</source>
        <translation>
            <numerusform>ServoDesk works: %n step in %1 s.</numerusform>
            <numerusform>ServoDesk works: %n steps in %1 s.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::SnapshotActions</name>
    <message numerus="yes">
        <source>Delete %n snapshot(s)?</source>
        <translation>
            <numerusform>Delete %n snapshot?</numerusform>
            <numerusform>Delete %n snapshots?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::SnapshotPane</name>
    <message numerus="yes">
        <source>%n other(s)</source>
        <translation>
            <numerusform>%n other</numerusform>
            <numerusform>%n others</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::SweepGoalList</name>
    <message numerus="yes">
        <source>%1 (%n goal(s))</source>
        <translation>
            <numerusform>%1 (%n goal)</numerusform>
            <numerusform>%1 (%n goals)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::SweepLegsModel</name>
    <message numerus="yes">
        <source>%n reading(s) lost</source>
        <translation>
            <numerusform>%n reading lost</numerusform>
            <numerusform>%n readings lost</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::SweepResults</name>
    <message numerus="yes">
        <source>The test was paused by %n bus interruption(s).</source>
        <translation>
            <numerusform>The test was paused by %n bus interruption.</numerusform>
            <numerusform>The test was paused by %n bus interruptions.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::TemplateDialog</name>
    <message numerus="yes">
        <source>Save %n row(s)…</source>
        <translation>
            <numerusform>Save %n row…</numerusform>
            <numerusform>Save %n rows…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::TrendReplay</name>
    <message numerus="yes">
        <source>Recording %1: %Ln row(s)</source>
        <translation>
            <numerusform>Recording %1: %Ln row</numerusform>
            <numerusform>Recording %1: %Ln rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln line(s) could not be read</source>
        <translation>
            <numerusform>%Ln line could not be read</numerusform>
            <numerusform>%Ln lines could not be read</numerusform>
        </translation>
    </message>
</context>
</TS>
