// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/doctor_system.hpp>
#include <tests/lab/made_up_machine.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace tegotae {
namespace {

using ::testing::HasSubstr;

MadeUpMachine linux_machine(const std::string& build) {
  MadeUpMachine machine;
  machine.write("proc/version", "Linux version 6.1.0-18 (builder) (gcc) #1 SMP " + build + " Debian\n");
  machine.write("proc/sys/kernel/osrelease", "6.1.0-18\n");
  return machine;
}

void expect(const Finding& finding, Verdict verdict, const std::string& words) {
  EXPECT_EQ(name_of(finding.verdict), name_of(verdict)) << finding.found;
  EXPECT_THAT(finding.found, HasSubstr(words));
  EXPECT_EQ(finding.mend.empty(), verdict == Verdict::kOk) << finding.mend;
}

TEST(DoctorSystem, KernelsByTheirPreemption) {
  expect(kernel_finding(linux_machine("PREEMPT_RT").roots()), Verdict::kOk, "Linux 6.1.0-18, preemption: real-time.");
  expect(kernel_finding(linux_machine("PREEMPT").roots()), Verdict::kOk, "full");
  expect(kernel_finding(linux_machine("").roots()), Verdict::kCouldBeBetter, "voluntary or none");
  const MadeUpMachine old_name = linux_machine("PREEMPT");
  old_name.write("sys/kernel/realtime", "1\n");
  expect(kernel_finding(old_name.roots()), Verdict::kOk, "real-time");
}

TEST(DoctorSystem, PreemptionThatIsChosenAtBoot) {
  const MadeUpMachine machine = linux_machine("PREEMPT_DYNAMIC");
  expect(kernel_finding(machine.roots()), Verdict::kCouldBeBetter, "told to root only");
  machine.write("proc/cmdline", "quiet preempt=full splash\n");
  expect(kernel_finding(machine.roots()), Verdict::kOk, "preemption: full");
  machine.write("sys/kernel/debug/sched/preempt", "none (voluntary) full\n");
  expect(kernel_finding(machine.roots()), Verdict::kCouldBeBetter, "preemption: voluntary");
  machine.write("sys/kernel/debug/sched/preempt", "none voluntary (full)\n");
  expect(kernel_finding(machine.roots()), Verdict::kOk, "preemption: full");
  EXPECT_THAT(kernel_finding(linux_machine("").roots()).mend,
              testing::AllOf(HasSubstr("linux-image-rt-amd64"), HasSubstr("preempt=full")));
}

TEST(DoctorSystem, AMachineThatTellsNothing) {
  const MadeUpMachine machine;
  expect(kernel_finding(machine.roots()), Verdict::kCouldBeBetter, "does not tell its version");
  expect(scheduling_finding(machine.roots(), false), Verdict::kCouldBeBetter, "limit of real-time priority unknown");
  expect(memory_finding(machine.roots(), true), Verdict::kOk, "limit of locked memory unknown");
  expect(governor_finding(machine.roots()), Verdict::kOk, "does not control it here");
}

void write_rights(const MadeUpMachine& machine, const std::string& capabilities, int user) {
  machine.write("proc/self/limits",
                "Limit                     Soft Limit           Hard Limit           Units\n"
                "Max locked memory         8388608              8388608              bytes\n"
                "Max realtime priority     95                   95                   \n");
  machine.write("proc/self/status", "Name:\tx\nUid:\t" + std::to_string(user) + "\t" + std::to_string(user) +
                                        "\t0\t0\nCapPrm:\t0000000000000000\nCapEff:\t" + capabilities + "\n");
}

TEST(DoctorSystem, RightsOfAPerson) {
  const MadeUpMachine machine;
  write_rights(machine, "0000000000000000", 1000);
  expect(scheduling_finding(machine.roots(), true), Verdict::kOk,
         "granted (limit of real-time priority 95, without CAP_SYS_NICE)");
  const Finding refused = scheduling_finding(machine.roots(), false);
  expect(refused, Verdict::kCouldBeBetter, "is refused (limit of real-time priority 95");
  EXPECT_THAT(refused.mend, HasSubstr("/etc/security/limits.d/realtime.conf"));
  const Finding memory = memory_finding(machine.roots(), false);
  expect(memory, Verdict::kCouldBeBetter, "limit of locked memory 8388608 bytes, without CAP_IPC_LOCK");
  EXPECT_THAT(memory.mend, HasSubstr("memlock unlimited"));
}

TEST(DoctorSystem, RightsOfRootInAContainer) {
  const MadeUpMachine machine;
  write_rights(machine, "0000000000800000", 0);  // CAP_SYS_NICE alone
  const Finding refused = scheduling_finding(machine.roots(), false);
  expect(refused, Verdict::kCouldBeBetter, "with CAP_SYS_NICE");
  EXPECT_THAT(refused.mend, testing::Not(HasSubstr("sudo"))) << "who is root already is not told to use sudo";
  EXPECT_THAT(memory_finding(machine.roots(), false).found, HasSubstr("without CAP_IPC_LOCK"));
  write_rights(machine, "0000000000004000", 0);  // CAP_IPC_LOCK alone
  EXPECT_THAT(memory_finding(machine.roots(), false).found, HasSubstr("with CAP_IPC_LOCK"));
  EXPECT_THAT(memory_finding(machine.roots(), false).mend, HasSubstr("memlock=-1"));
  EXPECT_THAT(scheduling_finding(machine.roots(), false).found, HasSubstr("without CAP_SYS_NICE"));
}

TEST(DoctorSystem, GovernorsOfTheProcessors) {
  const MadeUpMachine machine;
  const std::string cpu = "sys/devices/system/cpu/cpu";
  machine.write(cpu + "0/cpufreq/scaling_governor", "performance\n");
  expect(governor_finding(machine.roots()), Verdict::kOk, "governor performance on 1 processor.");
  machine.write(cpu + "1/cpufreq/scaling_governor", "powersave\n");
  machine.write(cpu + "2/cpufreq/scaling_governor", "powersave\n");
  const Finding mixed = governor_finding(machine.roots());
  expect(mixed, Verdict::kCouldBeBetter, "performance on 1, powersave on 2 processors.");
  EXPECT_THAT(mixed.mend, HasSubstr("scaling_governor"));
}

}  // namespace
}  // namespace tegotae
