// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/diagnosis_text.h"

#include "text/bus_text.h"
#include "text/language.h"
#include "text/text_table.h"

#include <array>
#include <chrono>

namespace text {
namespace {
using base::Cause;
using base::Evidence;
using base::EvidenceKind;

/// Less is not worth a figure.
constexpr base::Duration shortestTime = std::chrono::microseconds(500);

struct CauseEntry {
    Cause key;
    const char* text;
    const char* remedy;
};

/// A port that could not be opened has the texts of its error.
constexpr std::array causes{
    CauseEntry{Cause::Found,
               QT_TRANSLATE_NOOP("text", "The servos that were found reply reliably."),
               QT_TRANSLATE_NOOP(
                   "text", "If a servo is missing, check its cable and power supply first. Then "
                           "connect only that servo and run the diagnosis again; if no servo "
                           "replies, the diagnosis tries more baud rates and protocols.")},
    CauseEntry{
        Cause::PortBusy, QT_TRANSLATE_NOOP("text", "Another program is also using the port."),
        QT_TRANSLATE_NOOP(
            "text",
            "Close the other program; otherwise, each program takes replies meant for the other.")},
    CauseEntry{
        Cause::NoServoOrNoPower,
        QT_TRANSLATE_NOOP("text", "No servo is connected, or the servos have no power."),
        QT_TRANSLATE_NOOP(
            "text",
            "Measure the supply voltage at a servo's connector. On an adapter board, connect the "
            "supply to the terminal next to the servo connectors; USB does not power servos. Then "
            "try one servo alone, with another cable, and check that RS-485 servos are connected "
            "to the RS-485 connector and all others to the TTL connector.")},
    CauseEntry{
        Cause::EchoOnly,
        QT_TRANSLATE_NOOP("text", "Only the adapter's echo comes back; no servo replies."),
        QT_TRANSLATE_NOOP(
            "text",
            "The adapter works. Measure the supply voltage at a servo's connector, check that the "
            "data wire and the ground reach the servo, and try one servo alone.")},
    CauseEntry{Cause::WrongBaudRate,
               QT_TRANSLATE_NOOP("text", "Some servos use a different baud rate."),
               QT_TRANSLATE_NOOP("text", "Connect at the baud rate at which they were found. To "
                                         "use one rate for all servos, change it in each of "
                                         "them.")},
    CauseEntry{
        Cause::OtherProtocol,
        QT_TRANSLATE_NOOP("text", "Some servos use a protocol other than the one selected."),
        QT_TRANSLATE_NOOP(
            "text", "Select the protocol with which they were found, or use automatic selection.")},
    CauseEntry{Cause::TwoServosOneId, QT_TRANSLATE_NOOP("text", "Several servos have the same ID."),
               QT_TRANSLATE_NOOP(
                   "text",
                   "Disconnect all but one of these servos, give the remaining servo an unused "
                   "ID, then connect the next one. Commissioning guides you through the steps.")},
    CauseEntry{
        Cause::LateAdapter, QT_TRANSLATE_NOOP("text", "The adapter delays the replies."),
        QT_TRANSLATE_NOOP(
            "text",
            "ServoDesk waits for late replies, but other programs may not find any servos; set "
            "their timeouts to more than this delay. For an FTDI adapter, set the latency timer to "
            "1 ms (on Linux in /sys/bus/usb-serial/devices/ttyUSB0/latency_timer, on Windows in "
            "Device Manager). If you use a network bridge, connect to it by cable.")},
    CauseEntry{
        Cause::ResponseLevel0,
        QT_TRANSLATE_NOOP("text", "Some servos do not acknowledge writes (response level 0)."),
        QT_TRANSLATE_NOOP(
            "text", "ServoDesk reads back every value it writes. Other programs may report that "
                    "the servo does not reply; to prevent this, set the response level to 1.")},
    CauseEntry{
        Cause::Noise, QT_TRANSLATE_NOOP("text", "Replies are damaged or lost on the line."),
        QT_TRANSLATE_NOOP("text",
                          "Check the connectors and cables, connect the grounds of the adapter and "
                          "the power supply, and keep cables short. Then disconnect the servos one "
                          "after another: a single faulty servo can disturb the whole bus. If this "
                          "happens only while servos move, the power supply is too weak.")},
    CauseEntry{
        Cause::BoardNotAdapter,
        QT_TRANSLATE_NOOP(
            "text",
            "The device on this port sends text from its own program instead of servo data."),
        QT_TRANSLATE_NOOP(
            "text",
            "The port belongs to a board that runs its own firmware. Load a pass-through program "
            "onto it that forwards all bytes to the servos, or use a servo adapter.")},
    CauseEntry{
        Cause::Bootloader,
        QT_TRANSLATE_NOOP("text", "A servo is in its bootloader and has no complete firmware."),
        QT_TRANSLATE_NOOP(
            "text", "Its firmware update was probably interrupted. Connect only this servo and "
                    "rescue it with the vendor's firmware file (Servo menu, Rescue firmware; "
                    "servodesk-cli firmware rescue FILE).")},
};

QString counted(const char* words, const Evidence& evidence)
{
    return translate("text", words).arg(evidence.id).arg(evidence.count).arg(evidence.total);
}

double milliseconds(base::Duration time)
{
    return std::chrono::duration<double, std::milli>(time).count();
}

QString idList(const Evidence& evidence)
{
    QStringList ids;
    for (const int id : evidence.ids)
        ids << QString::number(id);
    return joinItems(ids);
}

QString replyTimeText(const Evidence& evidence)
{
    if (evidence.time < shortestTime)
        return translate("text", "All servos reply without noticeable delay.");
    return translate("text", "The slowest servo (ID %1) replies after %2 ms.")
        .arg(evidence.id)
        .arg(milliseconds(evidence.time), 0, 'f', 1);
}

/// Of the line as a whole.
QString lineText(const Evidence& evidence)
{
    switch (evidence.kind) {
    case EvidenceKind::PortOpened:
        return translate("text", "%1 can be opened at %2 baud.")
            .arg(evidence.text)
            .arg(evidence.baud);
    case EvidenceKind::OtherProgram:
        return translate("text", "The port is also open in %1.").arg(evidence.text);
    case EvidenceKind::LatencyTimer:
        return translate("text", "The latency timer of the adapter is set to %1 ms.")
            .arg(milliseconds(evidence.time), 0, 'f', 0);
    case EvidenceKind::Echo:
        return translate("text",
                         "The adapter echoes what is sent; ServoDesk filters out the echo.");
    case EvidenceKind::NoEcho:
        return translate("text", "The adapter does not echo what is sent.");
    case EvidenceKind::NothingReceived:
        return translate("text", "Nothing was received at any of the %n baud rate(s) tried.",
                         nullptr, evidence.count);
    case EvidenceKind::BytesReceived:
        return translate("text", "%n byte(s) received after a query to all servos at %1 baud: %2",
                         nullptr, evidence.count)
            .arg(evidence.baud)
            .arg(evidence.text);
    case EvidenceKind::TextReceived:
        return translate("text", "Text received at %1 baud: %2")
            .arg(evidence.baud)
            .arg(evidence.text);
    case EvidenceKind::LineNeverIdle:
        return translate("text",
                         "At %1 baud, the line is never idle: a device is sending continuously.")
            .arg(evidence.baud);
    case EvidenceKind::RatesRefused:
        return translate("text", "The adapter does not support these baud rates: %1")
            .arg(evidence.text);
    case EvidenceKind::RateFixed:
        return translate("text", "The baud rate of this port is set elsewhere, so no other rate "
                                 "could be tried.");
    case EvidenceKind::BootloaderReplied:
        return translate("text", "The bootloader of a servo replies at %1 baud.")
            .arg(evidence.baud);
    case EvidenceKind::ServosFound:
        return translate("text", "%n servo(s) found at %1 baud (%2): ID %3", nullptr,
                         int(evidence.ids.size()))
            .arg(evidence.baud)
            .arg(protocolText(evidence.protocol), idList(evidence));
    default:
        return {};
    }
}
} // namespace

QString causeText(Cause cause)
{
    const CauseEntry* entry = entryFor(causes, cause);
    return entry != nullptr ? translate("text", entry->text) : base::causeName(cause);
}

QString causeRemedy(Cause cause)
{
    const CauseEntry* entry = entryFor(causes, cause);
    return entry != nullptr ? translate("text", entry->remedy) : QString();
}

QString evidenceText(const Evidence& evidence)
{
    switch (evidence.kind) {
    case EvidenceKind::ReplyTime:
        return replyTimeText(evidence);
    case EvidenceKind::AllReplied:
        return translate("text", "The replies to all %n test query(s) arrived undamaged.", nullptr,
                         evidence.count);
    case EvidenceKind::LostReplies:
        return counted(QT_TRANSLATE_NOOP("text", "ID %1: %2 of %3 replies were lost."), evidence);
    case EvidenceKind::DamagedReplies:
        return counted(QT_TRANSLATE_NOOP("text", "ID %1: %2 of %3 replies were damaged."),
                       evidence);
    case EvidenceKind::UnreadableReplies:
        return counted(QT_TRANSLATE_NOOP("text", "ID %1: %2 of %3 readings were damaged."),
                       evidence);
    case EvidenceKind::SecondReply:
        return counted(QT_TRANSLATE_NOOP("text", "ID %1: one request received several replies."),
                       evidence);
    case EvidenceKind::DifferentValues:
        return counted(QT_TRANSLATE_NOOP("text", "ID %1: the readings cannot come from one servo."),
                       evidence);
    case EvidenceKind::NoAcknowledgement:
        return counted(QT_TRANSLATE_NOOP("text", "ID %1 does not acknowledge writes."), evidence);
    default:
        return lineText(evidence);
    }
}
} // namespace text
