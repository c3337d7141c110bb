// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/history_text.h"

#include "text/translate.h"

#include <array>

namespace text {
namespace {
constexpr RefusalText newer{
    "newer version",
    QT_TRANSLATE_NOOP("text", "the history was written by a newer version of this program"),
    QT_TRANSLATE_NOOP("text", "This version of ServoDesk is too old to record changes in the "
                              "history, so nothing is written to the servo."),
    QT_TRANSLATE_NOOP("text",
                      "Use the newer version or another data folder (SERVODESK_DATA_DIR).")};
constexpr RefusalText busy{
    "locked", QT_TRANSLATE_NOOP("text", "the history has been locked for too long"),
    QT_TRANSLATE_NOOP(
        "text", "Another program has locked the history, or the history is on a network drive that "
                "does not respond. Without the history, nothing is written to the servo."),
    QT_TRANSLATE_NOOP("text", "Close other programs that have history.sqlite open, and try "
                              "again.")};
constexpr RefusalText damaged{
    "damaged", QT_TRANSLATE_NOOP("text", "the history database is damaged"),
    QT_TRANSLATE_NOOP("text", "The file on the disk is incomplete, or it is not a history file. "
                              "Without the history, nothing is written to the servo."),
    QT_TRANSLATE_NOOP(
        "text", "Close the program and move history.sqlite, together with history.sqlite-wal and "
                "history.sqlite-shm, to a safe place; a new history is created. \"sqlite3 "
                "history.sqlite .recover\" recovers what is still readable in the old file.")};
constexpr RefusalText unwritable{
    "unwritable", QT_TRANSLATE_NOOP("text", "the history cannot be written"),
    QT_TRANSLATE_NOOP("text", "The history file or its folder is read-only or belongs to another "
                              "user. Without the history, nothing is written to the servo."),
    QT_TRANSLATE_NOOP("text", "Get write permission for the file and its folder, or use another "
                              "data folder (SERVODESK_DATA_DIR).")};
/// By the detail of the refusal.
constexpr std::array refusals{
    RefusalText{"label-in-use", QT_TRANSLATE_NOOP("text", "another servo already has this label"),
                QT_TRANSLATE_NOOP("text", "Both servos have the same model, firmware and ID, so "
                                          "only the label distinguishes them."),
                QT_TRANSLATE_NOOP("text", "Choose another label, or confirm that the servo now "
                                          "replying is the one with this label.")},
    RefusalText{"no-snapshot", QT_TRANSLATE_NOOP("text", "no snapshot was taken before that time"),
                QT_TRANSLATE_NOOP(
                    "text", "The memory table at a past time is calculated from the last snapshot "
                            "before that time and the writes that followed the snapshot."),
                QT_TRANSLATE_NOOP("text", "Choose a later time.")},
    RefusalText{
        "unfinished-reference",
        QT_TRANSLATE_NOOP("text", "this test did not finish, so it cannot be a reference"),
        QT_TRANSLATE_NOOP("text",
                          "A stopped or interrupted test does not show how a good servo performs."),
        QT_TRANSLATE_NOOP("text", "Choose a completed test.")},
    RefusalText{
        "failed-reference",
        QT_TRANSLATE_NOOP("text", "this servo failed the test, so it cannot be a reference"),
        QT_TRANSLATE_NOOP("text", "Later tests of this model are compared with the reference."),
        QT_TRANSLATE_NOOP("text", "Choose a servo that passed.")},
};
} // namespace

const RefusalText* historyText(const base::Error& error)
{
    using base::ErrorCode;
    if (error.operation != QLatin1String("history"))
        return nullptr;
    switch (error.code) {
    case ErrorCode::FileFormat:
        return error.detail.contains(QLatin1String(newer.key)) ? &newer : &damaged;
    case ErrorCode::FileUnwritable:
        return error.detail.contains(QLatin1String(busy.key)) ? &busy : &unwritable;
    case ErrorCode::BadArgument:
    case ErrorCode::Refused:
        for (const RefusalText& words : refusals) {
            if (error.detail == QLatin1String(words.key))
                return &words;
        }
        return nullptr;
    default:
        return nullptr;
    }
}
} // namespace text
