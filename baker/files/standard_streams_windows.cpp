// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <cstdio>

#include "files/handle_windows.h"
#include "files/standard_streams.h"

/// Makes the C library replace patterns such as *.jpg with names of files, as shells do on other systems.
extern "C" {
extern int _dowildcard;
int _dowildcard = -1;
}

namespace coppermoon::files {
namespace {

constexpr int descriptor_of_errors = 2;
UINT earlier_code_page = 0;

void restore_code_page() { ::SetConsoleOutputCP(earlier_code_page); }

/// Ends the program at once, as a signal does on other systems. Incomplete files are removed; child processes end.
BOOL WINAPI end_when_told(DWORD) {
  restore_code_page();
  ::TerminateProcess(::GetCurrentProcess(), STATUS_CONTROL_C_EXIT);
  return TRUE;
}

/// Whether a standard stream is a console that understands escape sequences.
bool is_terminal(DWORD stream) {
  DWORD mode = 0;
  const auto console = ::GetStdHandle(stream);
  return ::GetConsoleMode(console, &mode) != 0 &&
         ::SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

}  // namespace

/// Sets the standard streams to binary mode, and consoles to UTF-8. Closed streams need no preparation, because using
/// them fails anyway. No window will ask the user what to do if the program or a library fails.
void prepare_standard_streams() {
  for (FILE* const stream : {stdin, stdout, stderr})
    if (const int number = ::_fileno(stream); number >= 0) ::_setmode(number, _O_BINARY);
  earlier_code_page = ::GetConsoleOutputCP();
  if (earlier_code_page != 0) ::SetConsoleOutputCP(CP_UTF8);
  is_terminal(STD_OUTPUT_HANDLE);
  ::SetConsoleCtrlHandler(end_when_told, TRUE);
  ::SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX | SEM_NOOPENFILEERRORBOX);
}

int end_program(int status) {
  std::fflush(nullptr);
  if (earlier_code_page != 0) restore_code_page();
  ::TerminateProcess(::GetCurrentProcess(), static_cast<UINT>(status));
  return status;
}

bool errors_on_terminal() { return is_terminal(STD_ERROR_HANDLE); }

void say_at_once(std::string_view words) {
  DWORD said = 0;
  ::WriteFile(::GetStdHandle(STD_ERROR_HANDLE), words.data(), static_cast<DWORD>(words.size()),
              &said, nullptr);
}

Handle silence_errors() {
  std::fflush(stderr);
  auto before = copied(reinterpret_cast<HANDLE>(::_get_osfhandle(descriptor_of_errors)));
  const int nowhere = ::_open("NUL", _O_WRONLY | _O_BINARY);
  if (before && nowhere >= 0) ::_dup2(nowhere, descriptor_of_errors);
  if (nowhere >= 0) ::_close(nowhere);
  return before;
}

void hear_errors(const Handle& before) {
  std::fflush(stderr);
  if (!before) return;
  auto again = copied(system_handle(before));
  const int heard = ::_open_osfhandle(std::exchange(again.number, -1), _O_BINARY);
  if (heard < 0) return;
  ::_dup2(heard, descriptor_of_errors);
  ::_close(heard);
}

}  // namespace coppermoon::files
