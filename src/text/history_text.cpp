// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/history_text.h"

#include "text/translate.h"

namespace text {
namespace {
constexpr RefusalText newer{
    "newer version",
    QT_TRANSLATE_NOOP("text", "the history was written by a newer version of this program"),
    QT_TRANSLATE_NOOP("text", "An older one cannot keep in it what it is about to change, so "
                              "nothing is written to a servo."),
    QT_TRANSLATE_NOOP("text", "Use the newer version, or another data folder "
                              "(SERVODESK_DATA_DIR).")};
constexpr RefusalText busy{
    "locked", QT_TRANSLATE_NOOP("text", "the history is in use for too long"),
    QT_TRANSLATE_NOOP("text", "Another program keeps it locked, or it lies on a network drive "
                              "that does not answer. Nothing is written to a servo without it."),
    QT_TRANSLATE_NOOP("text", "Close other programs that have history.sqlite open, and try "
                              "again.")};
constexpr RefusalText damaged{
    "damaged", QT_TRANSLATE_NOOP("text", "the history database is damaged"),
    QT_TRANSLATE_NOOP("text", "The disk lost part of it, or the file is something else. Nothing "
                              "is written to a servo without it."),
    QT_TRANSLATE_NOOP("text", "Close the program and move history.sqlite, with the files "
                              "history.sqlite-wal and -shm, to a safe place; a new one is begun. "
                              "\"sqlite3 history.sqlite .recover\" gets out of the old one what "
                              "can be read.")};
constexpr RefusalText unwritable{
    "unwritable", QT_TRANSLATE_NOOP("text", "the history cannot be written"),
    QT_TRANSLATE_NOOP("text", "Its file or folder is read-only or belongs to somebody else. "
                              "Nothing is written to a servo without it."),
    QT_TRANSLATE_NOOP("text", "Give yourself the right to write to both, or use another data "
                              "folder (SERVODESK_DATA_DIR).")};
constexpr RefusalText oldJournal{
    "journal", QT_TRANSLATE_NOOP("text", "the journal of an earlier version cannot be read"),
    QT_TRANSLATE_NOOP("text", "It may hold a change that was interrupted, so nothing is written to "
                              "a servo before it is in the history."),
    QT_TRANSLATE_NOOP("text", "Give yourself the right to read it, or move it away if you know "
                              "that it is of no use.")};
constexpr RefusalText brokenJournal{
    "journal", QT_TRANSLATE_NOOP("text", "lines of an earlier version's journal cannot be read"),
    QT_TRANSLATE_NOOP("text", "The file was damaged, or a newer program wrote to it. What can be "
                              "read is in the history now; the file is kept."),
    QT_TRANSLATE_NOOP("text", "Such a line may tell of an interrupted change: check the EPROM lock "
                              "and the settings of servos that were in use then.")};
constexpr RefusalText labelInUse{
    "label-in-use", QT_TRANSLATE_NOOP("text", "another servo has this label"),
    QT_TRANSLATE_NOOP("text", "It is alike in model, firmware and ID, and only the label tells "
                              "the two apart."),
    QT_TRANSLATE_NOOP("text", "Choose another label, or say that the servo that answers now is "
                              "that one.")};
constexpr RefusalText noSnapshot{
    "no-snapshot", QT_TRANSLATE_NOOP("text", "no snapshot was taken by then"),
    QT_TRANSLATE_NOOP("text", "A table of the past is the last snapshot before it with the writes "
                              "since then."),
    QT_TRANSLATE_NOOP("text", "Choose a later time.")};
constexpr RefusalText unfinishedReference{
    "unfinished-reference",
    QT_TRANSLATE_NOOP("text", "this test did not finish, so it cannot be a reference"),
    QT_TRANSLATE_NOOP("text", "A test that was stopped or broken off has no verdict on a good "
                              "servo."),
    QT_TRANSLATE_NOOP("text", "Choose a test that ran to its end.")};
constexpr RefusalText failedReference{
    "failed-reference",
    QT_TRANSLATE_NOOP("text", "this servo failed the test, so it cannot be a reference"),
    QT_TRANSLATE_NOOP("text", "A reference is what later tests of its model are compared with."),
    QT_TRANSLATE_NOOP("text", "Choose a servo that passed.")};
} // namespace

const RefusalText* historyText(const base::Error& error)
{
    using base::ErrorCode;
    if (error.operation == QLatin1String("journal"))
        return error.code == ErrorCode::FileUnreadable ? &oldJournal
               : error.code == ErrorCode::FileFormat   ? &brokenJournal
                                                       : nullptr;
    if (error.operation != QLatin1String("history"))
        return nullptr;
    switch (error.code) {
    case ErrorCode::FileFormat:
        return error.detail.contains(QLatin1String(newer.detail)) ? &newer : &damaged;
    case ErrorCode::FileUnwritable:
        return error.detail.contains(QLatin1String(busy.detail)) ? &busy : &unwritable;
    case ErrorCode::BadArgument:
        return error.detail == QLatin1String(labelInUse.detail)   ? &labelInUse
               : error.detail == QLatin1String(noSnapshot.detail) ? &noSnapshot
                                                                  : nullptr;
    case ErrorCode::Refused:
        return error.detail == QLatin1String(unfinishedReference.detail) ? &unfinishedReference
               : error.detail == QLatin1String(failedReference.detail)   ? &failedReference
                                                                         : nullptr;
    default:
        return nullptr;
    }
}
} // namespace text
