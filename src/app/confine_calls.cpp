// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

#include "app/confine.hpp"

namespace meander {
namespace {

#if defined(__x86_64__)
constexpr unsigned kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned kArchitecture = 0;  // no filter
#endif

/// What no script needs: other programs, the network, other processes, the kernel itself. Worker processes talk over
/// socketpair, which stays.
constexpr long kRefused[] = {
    SYS_execve,
    SYS_execveat,
    SYS_socket,
    SYS_connect,
    SYS_bind,
    SYS_listen,
    SYS_accept,
    SYS_accept4,
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_process_vm_writev,
    SYS_mount,
    SYS_umount2,
    SYS_pivot_root,
    SYS_chroot,
    SYS_unshare,
    SYS_setns,
    SYS_bpf,
    SYS_perf_event_open,
    SYS_keyctl,
    SYS_add_key,
    SYS_request_key,
    SYS_init_module,
    SYS_finit_module,
    SYS_delete_module,
    SYS_kexec_load,
    SYS_reboot,
    SYS_swapon,
    SYS_swapoff,
    SYS_open_by_handle_at,
    SYS_userfaultfd,
    SYS_sethostname,
    SYS_setdomainname,
    SYS_settimeofday,
    SYS_clock_settime,
    SYS_symlinkat,
    SYS_linkat,
    SYS_mknodat,
    SYS_fchownat,
    SYS_setxattr,
#ifdef SYS_io_uring_setup
    SYS_io_uring_setup,
#endif
#ifdef SYS_pidfd_getfd
    SYS_pidfd_getfd,
#endif
#ifdef SYS_symlink
    SYS_symlink,
    SYS_link,
    SYS_mknod,
    SYS_chown,
    SYS_lchown,
#endif
};

sock_filter load(std::size_t offset) { return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(offset)); }
sock_filter give(unsigned action) { return BPF_STMT(BPF_RET | BPF_K, action); }

constexpr unsigned kNotPermitted = SECCOMP_RET_ERRNO | EPERM;

/// Requests to a terminal that type into it, as if the user did: the shell would run what comes.
void refuse_typing(std::vector<sock_filter>& steps) {
  constexpr unsigned kTyping[] = {TIOCSTI, TIOCLINUX};
  constexpr std::size_t kCount = std::size(kTyping);
  steps.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(SYS_ioctl), 0, 1 + 2 * kCount));
  steps.push_back(load(offsetof(seccomp_data, args) + sizeof(std::uint64_t)));  // lower half of the second
  for (const unsigned request : kTyping) {
    steps.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, request, 0, 1));
    steps.push_back(give(kNotPermitted));
  }
}

std::vector<sock_filter> program() {
  std::vector<sock_filter> steps = {
      load(offsetof(seccomp_data, arch)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kArchitecture, 1, 0),
      give(SECCOMP_RET_KILL_PROCESS),
      load(offsetof(seccomp_data, nr)),
  };
#if defined(__x86_64__)
  constexpr unsigned kX32 = 0x40000000;  // the other numbering of the same calls
  steps.push_back(BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, kX32, 0, 1));
  steps.push_back(give(kNotPermitted));
#endif
  for (const long call : kRefused) {
    steps.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call), 0, 1));
    steps.push_back(give(kNotPermitted));
  }
  refuse_typing(steps);
  steps.push_back(give(SECCOMP_RET_ALLOW));
  return steps;
}

}  // namespace

bool confine_calls() {
  if (kArchitecture == 0) return false;
  std::vector<sock_filter> steps = program();
  const sock_fprog filter{static_cast<unsigned short>(steps.size()), steps.data()};
  return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter, 0, 0) == 0;
}

}  // namespace meander
