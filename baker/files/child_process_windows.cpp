// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <windows.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cwchar>
#include <memory>

#include "algebra/error.h"
#include "files/environment.h"
#include "files/handle_windows.h"
#include "files/running_program.h"

namespace coppermoon::files {
namespace {

using algebra::Error;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Finds a program's file in folders that are listed as in PATH; empty if none of them has it.
fs::path found_in(const std::wstring& folders, const std::wstring& name) {
  std::wstring found(32768, L'\0');
  found.resize(::SearchPathW(folders.c_str(), name.c_str(), L".exe",
                             static_cast<DWORD>(found.size()), found.data(), nullptr));
  return found;
}

/// Quotes a word so that programs read it unchanged from a command line. Backslashes are doubled only before a quote.
std::wstring quoted(const std::wstring& word) {
  if (!word.empty() && word.find_first_of(L" \t\"") == word.npos) return word;
  std::wstring text = L"\"";
  std::size_t backslashes = 0;
  for (const wchar_t c : word) {
    if (c == L'"') text.append(backslashes + 1, L'\\');
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    text += c;
  }
  return text.append(backslashes, L'\\') + L'"';
}

/// The environment of this process with the given variables added or replaced, in the form that CreateProcess expects.
std::wstring environment_with(const std::vector<std::string>& variables) {
  std::wstring block;
  for (const auto& one : variables) block += wide(one) + L'\0';
  const std::unique_ptr<wchar_t, BOOL(WINAPI*)(LPWCH)> ours(::GetEnvironmentStringsW(),
                                                            &::FreeEnvironmentStringsW);
  for (const wchar_t* one = ours.get(); *one != 0; one += std::wcslen(one) + 1) {
    const std::wstring_view line = one;
    const auto name = line.substr(0, line.find(L'=', 1) + 1);
    if (std::ranges::none_of(variables, [&](const auto& other) {
          return ::_wcsnicmp(wide(other).c_str(), name.data(), name.size()) == 0;
        }))
      block.append(line) += L'\0';
  }
  return block += L'\0';
}

/// A job object that ends its programs and their child processes when the handle closes or this process ends.
Handle job_that_ends() {
  auto job = owned(::CreateJobObjectW(nullptr, nullptr));
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  ::SetInformationJobObject(system_handle(job), JobObjectExtendedLimitInformation, &limits,
                            sizeof limits);
  return job;
}

/// Waits until a program writes a message or ends.
///
/// Throws  Error  if the program exceeds its timeout
void await(const Handle& words, const Program& program, double timeout_s, Clock::time_point start) {
  DWORD there = 0;
  while (timeout_s > 0 && there == 0 &&
         ::PeekNamedPipe(system_handle(words), nullptr, 0, nullptr, &there, nullptr)) {
    if (std::chrono::duration<double>(Clock::now() - start).count() >= timeout_s)
      throw not_done(program, timeout_s);
    if (there == 0) ::Sleep(10);
  }
}

}  // namespace

std::string own_output(const Handle& result) { return name_of(result); }

std::string program_file(const std::string& name, const Installation& windows) {
  if (fs::path(name).has_parent_path()) return name;
  const auto path = wide(variable("PATH"));
  auto found = found_in(path, wide(name));
  if (windows.file.empty() || !found.empty()) return found.empty() ? name : found.string();
  const auto programs = fs::path(variable("ProgramFiles")) / windows.folder;
  for (const auto& folders : {path, programs.wstring()})
    if (found.empty()) found = found_in(folders, wide(windows.file));
  return found.empty() ? name : found.string();
}

Pipe::Pipe() {
  constexpr DWORD room = 65536;  // size of the pipe's buffer [bytes]
  HANDLE end = nullptr, begin = nullptr;
  if (!::CreatePipe(&end, &begin, nullptr, room))
    throw Error(fmt::format("no pipe to another program: {}", last_error().message()));
  out = owned(end);
  in = owned(begin);
}

std::string read_some(const Handle& pipe) {
  std::array<char, 4096> buffer;
  DWORD count = 0;
  ::ReadFile(system_handle(pipe), buffer.data(), buffer.size(), &count, nullptr);
  return {buffer.data(), count};
}

RunningProgram::~RunningProgram() {
  if (id == 0) return;
  tree.close();
  ::TerminateProcess(reinterpret_cast<HANDLE>(id), 1);
  status();
}

int RunningProgram::status() {
  const auto process = owned(reinterpret_cast<HANDLE>(id));
  DWORD result = 0;
  ::WaitForSingleObject(system_handle(process), INFINITE);
  ::GetExitCodeProcess(system_handle(process), &result);
  id = 0;
  return static_cast<int>(result);
}

void start(RunningProgram& running, const Program& program, const Streams& streams) {
  const fs::path file = program_file(program.words[0]);
  if (!fs::exists(file))
    throw Error(fmt::format("{}: not found; install it, and name its folder in the variable PATH",
                            program.words[0]));
  std::wstring line = quoted(file.wstring());
  for (std::size_t i = 1; i < program.words.size(); ++i)
    line += L' ' + quoted(wide(program.words[i]));
  auto variables = environment_with(program.variables);

  const Handle nothing =
      owned(::CreateFileW(L"NUL", GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE,
                          nullptr, OPEN_EXISTING, 0, nullptr));
  const auto given = [&](const Handle* stream) {
    return copied(system_handle(stream == nullptr ? nothing : *stream), true);
  };
  const Handle input = given(streams.input), output = given(streams.output),
               error = given(streams.error);
  std::array handles{system_handle(input), system_handle(output), system_handle(error)};
  alignas(std::max_align_t) std::array<std::byte, 256> room;
  STARTUPINFOEXW how{};
  how.StartupInfo.cb = sizeof how;
  how.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
  how.StartupInfo.hStdInput = handles[0];
  how.StartupInfo.hStdOutput = handles[1];
  how.StartupInfo.hStdError = handles[2];
  how.lpAttributeList = reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(room.data());
  SIZE_T size = room.size();
  PROCESS_INFORMATION made{};
  if (!::InitializeProcThreadAttributeList(how.lpAttributeList, 1, 0, &size) ||
      !::UpdateProcThreadAttribute(how.lpAttributeList, 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST,
                                   handles.data(), sizeof handles, nullptr, nullptr) ||
      !::CreateProcessW(
          file.c_str(), line.data(), nullptr, nullptr, TRUE,
          (program.outlives_us ? DETACHED_PROCESS : CREATE_SUSPENDED | CREATE_NO_WINDOW) |
              CREATE_NEW_PROCESS_GROUP | CREATE_UNICODE_ENVIRONMENT | EXTENDED_STARTUPINFO_PRESENT,
          variables.data(), program.folder.c_str(), &how.StartupInfo, &made))
    throw Error(fmt::format("{}: cannot be run: {}", program.words[0], last_error().message()));
  const auto thread = owned(made.hThread);
  running.id = reinterpret_cast<std::intptr_t>(made.hProcess);
  if (program.outlives_us) return;  // was not suspended: this process might end before resuming it
  running.tree = job_that_ends();
  ::AssignProcessToJobObject(system_handle(running.tree), made.hProcess);
  ::ResumeThread(made.hThread);
}

/// Windows does not report when a file is closed, so every program runs to its end.
bool run_heard(const Program& program, const Hearing& hearing) {
  Pipe words;
  RunningProgram running;
  start(running, program, {.output = hearing.result, .error = &words.in});
  words.in.close();
  const auto began = Clock::now();
  for (;;) {
    await(words.out, program, hearing.timeout_s, began);
    const auto said = read_some(words.out);
    if (said.empty()) break;
    if (hearing.hear) hearing.hear(said);
  }
  const auto status = static_cast<unsigned>(running.status());
  if (status >= 0xC0000000U)
    throw Error(fmt::format("{}: ended by exception {:#x}", program.words[0], status));
  return status == 0;
}

}  // namespace coppermoon::files
