// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_file.h"

#include "files/file_error.h"

#include <QFileInfo>

#include <algorithm>
#include <cerrno>

namespace recording {
namespace {
const QString fileOperation = QStringLiteral("record");

QByteArray bytesOf(const std::string& text)
{
    return QByteArray::fromRawData(text.data(), qsizetype(text.size()));
}
} // namespace

void RecordingBlock::clear()
{
    text.clear();
    rowEnds.clear();
}

RecordingFile::RecordingFile(const QString& path)
    : m_path(path)
    , m_file(path, files::FileHandle::Mode::Append)
{}

base::Result<std::unique_ptr<RecordingFile>> RecordingFile::create(const QString& path,
                                                                   const std::string& head)
{
    if (path.isEmpty())
        return tl::unexpected(files::noFileNameError(fileOperation));
    std::unique_ptr<RecordingFile> made(new RecordingFile(path));
    files::FileHandle& file = made->m_file;
    if (!file.isOpen())
        return tl::unexpected(made->lastError());
    const auto info = file.info();
    if (!info)
        return tl::unexpected(made->lastError());
    made->m_fileId = info->id;
    if (info->regular && !file.truncate(0))
        return tl::unexpected(made->lastError());
    if (const auto written = made->append({head, {}}); !written)
        return tl::unexpected(written.error());
    // /dev/full and the like cannot be synced and need no sync.
    if (info->regular &&
        (!file.sync() || !files::FileHandle::syncFolder(QFileInfo(path).absolutePath())))
        return tl::unexpected(made->lastError());
    return made;
}

base::Result<void> RecordingFile::append(const RecordingBlock& block)
{
    if (m_file.write(bytesOf(block.text))) {
        m_size += block.text.size();
        m_rows += block.rowEnds.size();
        return {};
    }
    const base::Error error = lastError();
    truncateToWholeLines(block);
    return tl::unexpected(error);
}

/// Part of the block may have been written: its whole lines stay.
void RecordingFile::truncateToWholeLines(const RecordingBlock& block)
{
    const auto info = m_file.info();
    const std::uint64_t currentSize = info ? std::uint64_t(info->size) : 0;
    const std::uint64_t addedBytes = currentSize > m_size ? currentSize - m_size : 0;
    const std::size_t end =
        addedBytes == 0 ? block.text.npos : block.text.rfind('\n', std::size_t(addedBytes) - 1);
    const std::size_t kept = end == block.text.npos ? 0 : end + 1;
    m_size += kept;
    m_file.truncate(qint64(m_size));
    m_rows += std::uint64_t(std::upper_bound(block.rowEnds.begin(), block.rowEnds.end(), kept) -
                            block.rowEnds.begin());
}

base::Result<void> RecordingFile::flush()
{
    if (const auto named = checkFile(); !named)
        return named;
    if (!m_file.sync())
        return tl::unexpected(lastError());
    return {};
}

/// Writing to a file that was deleted or moved away succeeds, but the data is lost.
base::Result<void> RecordingFile::checkFile() const
{
    const auto named = files::FileHandle::infoOf(m_path);
    const bool mine = named && named->id == m_fileId;
    if (mine && (!named->regular || std::uint64_t(named->size) == m_size))
        return {};
    const QFileInfo folder(QFileInfo(m_path).absolutePath());
    const QString what = !folder.exists() ? QStringLiteral("the folder is gone")
                         : !named         ? QStringLiteral("the file was deleted or moved away")
                         : mine           ? QStringLiteral("another program changed the file")
                                          : QStringLiteral("another file took its place");
    return base::fail(base::ErrorCode::FileUnwritable, fileOperation,
                      m_path + QStringLiteral(": ") + what);
}

base::Error RecordingFile::lastError() const
{
    return files::fileError(base::ErrorCode::FileUnwritable, fileOperation, m_path, errno);
}
} // namespace recording
