// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/scan/found_servos.h"

#include "device/reader.h"
#include "jobs/scan/scan_duplicate_ids.h"
#include "jobs/scan/scan_list.h"

#include <algorithm>

namespace jobs {
namespace {
using base::ErrorCode;
using base::Protocol;

/// The list also shows an open lock, and alarms where they do not come with every reply.
std::vector<catalog::Role> missingStateRoles(const device::Servo& servo)
{
    using catalog::Role;
    std::vector<Role> missingRoles;
    const auto addMissing = [&](std::initializer_list<Role> roles) {
        for (const Role role : roles) {
            if (servo.profile->byRole(role) != nullptr && !servo.raw(role))
                missingRoles.push_back(role);
        }
    };
    addMissing({Role::BaudRate, Role::Lock});
    if (!servo.repliesCarryStatus())
        addMissing({Role::Status});
    if (!servo.repliesCarryStatus() && servo.profile->byRole(Role::Status) == nullptr)
        addMissing({Role::PresentTemperature, Role::MaxTemperature, Role::PresentVoltage,
                    Role::MinVoltage, Role::MaxVoltage});
    return missingRoles;
}
} // namespace

FoundServos::FoundServos(const device::Context& context, const ScanSpec& spec,
                         const OnFound& onFound, ScanProgress& progress)
    : m_context(context)
    , m_spec(spec)
    , m_onFound(onFound)
    , m_progress(progress)
{}

bool FoundServos::hasIdentified() const
{
    return std::any_of(m_servos.begin(), m_servos.end(),
                       [](const FoundServo& one) { return one.servo.profile != nullptr; });
}

bool FoundServos::hasIdentifiedAt(int baud) const
{
    return std::any_of(m_servos.begin(), m_servos.end(), [baud](const FoundServo& one) {
        return one.servo.profile != nullptr && one.servo.baud == baud;
    });
}

std::vector<FoundServo> FoundServos::unidentifiedAt(int baud) const
{
    std::vector<FoundServo> unidentified;
    std::copy_if(m_servos.begin(), m_servos.end(), std::back_inserter(unidentified),
                 [baud](const FoundServo& one) {
                     return one.servo.profile == nullptr && one.servo.baud == baud;
                 });
    return unidentified;
}

int FoundServos::countAt(int baud, Protocol protocol) const
{
    return int(std::count_if(m_servos.begin(), m_servos.end(), [&](const FoundServo& found) {
        return found.servo.baud == baud && found.servo.protocol == protocol;
    }));
}

FoundServo* FoundServos::findListed(int id, int baud, Protocol protocol)
{
    const auto known = std::find_if(m_servos.begin(), m_servos.end(), [&](const FoundServo& found) {
        return found.servo.id == id && found.servo.baud == baud && found.servo.protocol == protocol;
    });
    return known == m_servos.end() ? nullptr : &*known;
}

base::Result<void> FoundServos::add(int id, int baud, const RateScan& search)
{
    const IdResponse& response = search.responsesById().at(id);
    if (FoundServo* known = findListed(id, baud, search.protocol())) {
        const bool hasNews = (response.hasDuplicateId() && !known->duplicateSuspected) ||
                             (response.late && !known->lateReplySeen);
        known->duplicateSuspected = known->duplicateSuspected || response.hasDuplicateId();
        known->lateReplySeen = known->lateReplySeen || response.late;
        if (hasNews && m_onFound)
            m_onFound(*known);
        return {};
    }
    FoundServo found;
    found.servo.protocol = search.protocol();
    found.servo.id = id;
    found.servo.baud = baud;
    found.servo.port = m_context.bus.portName();
    found.servo.status = response.status;
    found.lateReplySeen = response.late;
    found.duplicateSuspected = response.hasDuplicateId();
    // A servo that has answered is listed even if the stop comes before its name is known.
    if (m_spec.identify && response.replies > 0 && !m_context.stop.isRequested()) {
        const auto done = identify(found);
        if (!done && done.error().code != ErrorCode::Stopped)
            return done;
    }
    m_progress.countFound();
    m_servos.push_back(found);
    if (m_onFound)
        m_onFound(found);
    return {};
}

base::Result<void> FoundServos::identify(FoundServo& found) const
{
    auto servo = device::identify(m_context, found.servo.id, found.servo.protocol);
    if (!servo) {
        const ErrorCode code = servo.error().code;
        const bool broken = code == ErrorCode::Garbled || code == ErrorCode::UnexpectedReply;
        found.duplicateSuspected = found.duplicateSuspected || broken;
        return base::endsJob(code) ? tl::unexpected(servo.error()) : base::Result<void>{};
    }
    found.servo = std::move(*servo);
    const auto hasDuplicateId = suspectDuplicateId(m_context, found.servo);
    if (!hasDuplicateId)
        return tl::unexpected(hasDuplicateId.error());
    found.duplicateSuspected = found.duplicateSuspected || *hasDuplicateId;
    return readState(found.servo);
}

base::Result<void> FoundServos::readState(device::Servo& servo) const
{
    if (m_context.stop.isRequested())
        return {};
    const auto read = device::readRoles(m_context, servo, missingStateRoles(servo));
    return !read && base::endsJob(read.error().code) ? read : base::Result<void>{};
}

std::vector<FoundServo> FoundServos::takeSorted(const std::vector<int>& rates)
{
    dropNeighborRates(m_servos);
    sortFound(m_servos, rates);
    if (familiesMixed(m_servos))
        m_context.note(device::NoticeCode::MixedFamilies, -1);
    return std::move(m_servos);
}
} // namespace jobs
