// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: the meander authors
#include "repl/line.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
// readline's headers need <cstdio> before them
#include <readline/history.h>
#include <readline/readline.h>

#include "base/data_folder.hpp"
#include "repl/history.hpp"
#include "script/terminal_query.hpp"

namespace meander::repl {
namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP, SIGTSTP, SIGWINCH, SIGQUIT};

// readline calls back without a context of ours.
LineEditor::Completer completer;
std::optional<std::string> entered;
bool finished = false;
std::string typed_ahead;  ///< keys that somebody else has read for the prompt
volatile std::sig_atomic_t arrived[NSIG];

void note_signal(int signal) { arrived[signal] = 1; }

bool take_signal(int signal) {
  const bool was_there = arrived[signal] != 0;
  arrived[signal] = 0;
  return was_there;
}

void on_line(char* text) {
  finished = true;
  if (text) entered = text;
  std::free(text);
  rl_callback_handler_remove();
}

/// Signals reach the program only while it waits in ppoll; there they are noted and acted on in plain code, since
/// readline may not be called from a handler.
class NotedSignals {
 public:
  NotedSignals() {
    sigset_t noted;
    sigemptyset(&noted);
    struct sigaction action {};
    action.sa_handler = note_signal;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
      arrived[kSignals[i]] = 0;
      sigaddset(&noted, kSignals[i]);
      sigaction(kSignals[i], &action, &previous_[i]);
    }
    pthread_sigmask(SIG_BLOCK, &noted, &waiting_mask_);
  }
  ~NotedSignals() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &previous_[i], nullptr);
    pthread_sigmask(SIG_SETMASK, &waiting_mask_, nullptr);
  }
  NotedSignals(const NotedSignals&) = delete;
  NotedSignals& operator=(const NotedSignals&) = delete;

  /// True when a key can be read.
  bool wait_for_key() const {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    return ppoll(&input, 1, nullptr, &waiting_mask_) > 0;
  }

 private:
  std::array<struct sigaction, kSignals.size()> previous_;
  sigset_t waiting_mask_;
};

/// Does with the terminal restored what the signal does by itself.
void obey(int signal) {
  rl_deprep_terminal();
  std::signal(signal, SIG_DFL);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  raise(signal);
  pthread_sigmask(SIG_UNBLOCK, &only, nullptr);  // ends or stops here; goes on when continued
  pthread_sigmask(SIG_BLOCK, &only, nullptr);
  std::signal(signal, note_signal);
  rl_prep_terminal(1);
  rl_forced_update_display();
}

/// True when the line is given up. SIGQUIT (Ctrl-\) means nothing here.
bool act_on_signals() {
  if (take_signal(SIGWINCH)) rl_resize_terminal();
  for (const int signal : {SIGTERM, SIGHUP, SIGTSTP})
    if (take_signal(signal)) obey(signal);
  if (!take_signal(SIGINT)) return false;
  rl_callback_sigcleanup();
  std::fputs("^C", rl_outstream);
  rl_free_line_state();
  rl_callback_handler_remove();
  std::fputc('\n', rl_outstream);
  return true;
}

/// The array that readline wants: the common beginning, the words, null; all for it to free.
char** match_array(const std::vector<std::string>& words) {
  if (words.empty()) return nullptr;
  std::string common = words.front();
  for (const std::string& word : words) {
    const auto end = std::mismatch(common.begin(), common.end(), word.begin(), word.end()).first;
    common.erase(end, common.end());
  }
  auto* matches = static_cast<char**>(std::malloc((words.size() + 2) * sizeof(char*)));
  std::size_t count = 0;
  matches[count++] = strdup(common.c_str());
  if (words.size() > 1)
    for (const std::string& word : words) matches[count++] = strdup(word.c_str());
  matches[count] = nullptr;
  return matches;
}

/// File names as readline finds them, then those that only the data folder has.
char* next_file_name(const char* text, int state) {
  static std::vector<std::string> more;
  if (state == 0) more = data_files(text);
  if (char* name = rl_filename_completion_function(text, state)) return name;
  while (!more.empty()) {
    const std::string name = std::move(more.back());
    more.pop_back();
    if (access(name.c_str(), F_OK) != 0) return strdup(name.c_str());
  }
  return nullptr;
}

/// readline has an idea of its own where the word starts: what it lacks or has too much of the beginning.
std::vector<std::string> words_from(std::size_t start, const script::Completion& completion) {
  std::vector<std::string> words = completion.words;
  for (std::string& word : words) {
    if (start < completion.start) word.insert(0, rl_line_buffer + start, completion.start - start);
    if (start > completion.start) word.erase(0, start - completion.start);
  }
  return words;
}

char** complete_word(const char* text, int start, int end) {
  rl_attempted_completion_over = 1;
  rl_completion_append_character = '\0';
  const script::Completion completion = completer(std::string_view(rl_line_buffer, static_cast<std::size_t>(end)));
  if (!completion.file_name) return match_array(words_from(static_cast<std::size_t>(start), completion));
  rl_filename_completion_desired = 1;
  return rl_completion_matches(text, next_file_name);
}

/// The arguments of commands are words as in a shell.
char* word_breaks() {
  static char blanks[] = " \t";
  return rl_line_buffer[std::strspn(rl_line_buffer, blanks)] == '.' ? blanks : nullptr;
}

bool more_keys_wait() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, 0) > 0;
}

/// The terminal says where a paste begins and ends.
bool marks_pastes() { return std::strcmp(rl_variable_value("enable-bracketed-paste"), "on") == 0; }

/// Tab indents at the start of a line that goes on with another, and in a paste that comes as single keys.
int complete_or_indent(int count, int key) {
  const char* end = rl_line_buffer + rl_point;
  const bool blank = std::all_of<const char*>(rl_line_buffer, end, [](char c) { return c == ' ' || c == '\t'; });
  const bool continues = std::strcmp(rl_prompt, kContinuation) == 0;
  const bool pasted = more_keys_wait() && !marks_pastes();
  if ((blank && continues) || pasted) return rl_insert(count, key);
  if (rl_last_func == complete_or_indent) rl_last_func = rl_complete;  // the second Tab in a row lists
  return rl_complete(count, key);
}

/// Drawing anew for every key of a long paste would take the square of its length.
void redisplay() {
  constexpr int kLong = 1000;
  if (rl_end < kLong || !more_keys_wait()) rl_redisplay();
}

int accept_line(int count, int key) {
  rl_redisplay();
  return rl_newline(count, key);
}

/// Without a locale readline would take the bytes of an umlaut for keys pressed with Meta.
void expect_utf8() {
  for (const char* variable : {"LC_ALL", "LC_CTYPE", "LANG"})
    if (const char* value = std::getenv(variable); value && *value) return;
  std::setlocale(LC_CTYPE, "C.UTF-8");
}

/// Keys typed ahead come before all that wait in the terminal, also where readline takes several at once.
int next_key(std::FILE* stream) {
  if (typed_ahead.empty()) return rl_getc(stream);
  const unsigned char key = static_cast<unsigned char>(typed_ahead.front());
  typed_ahead.erase(0, 1);
  return key;
}

void set_up_readline() {
  expect_utf8();
  rl_readline_name = "meander";
  rl_catch_signals = 0;
  rl_catch_sigwinch = 0;
  rl_getc_function = next_key;
  rl_attempted_completion_function = complete_word;
  rl_completer_word_break_characters = " \t\n\"'`$@><=;|&{}()[]+-*/%^~#,.:";
  rl_completion_word_break_hook = word_breaks;
  rl_basic_quote_characters = "\"'";
  rl_completer_quote_characters = "\"'";
  rl_variable_bind("show-all-if-ambiguous", "on");
  rl_bind_key('\t', complete_or_indent);
  rl_bind_key('\r', accept_line);
  rl_bind_key('\n', accept_line);
  if (!isatty(STDOUT_FILENO)) rl_outstream = stderr;  // results go elsewhere: keep them free of prompts
  rl_initialize();
  if (!marks_pastes()) rl_redisplay_function = redisplay;  // readline marks none for those who draw themselves
}

/// Types the keys that somebody else has read for the prompt.
void type_ahead() {
  typed_ahead += script::take_typed_ahead();
  while (!finished && !typed_ahead.empty()) rl_callback_read_char();
}

void take_key() {
  if (script::read_late_answer())
    type_ahead();
  else
    rl_callback_read_char();
}

}  // namespace

LineEditor::LineEditor(Completer complete, const std::vector<std::string>& history)
    : interactive_(isatty(STDIN_FILENO)) {
  completer = std::move(complete);
  if (!interactive_) return;
  set_up_readline();
  using_history();
  stifle_history(static_cast<int>(History::kMost));
  for (const std::string& entry : history) add_history(entry.c_str());
}

void LineEditor::remember(const std::string& entry) {
  if (!interactive_ || entry.empty()) return;
  for (int i = history_length - 1; i >= 0; --i) {
    const HIST_ENTRY* known = history_get(history_base + i);
    if (!known || entry != known->line) continue;
    free_history_entry(remove_history(i));
    break;
  }
  add_history(entry.c_str());
}

LineEnd LineEditor::read_terminal(const std::string& prompt, std::string& line) {
  const NotedSignals signals;
  finished = false;
  entered.reset();
  rl_eof_found = 0;  // readline's callbacks never take back an earlier Ctrl-D, and write an empty line for it
  rl_callback_handler_install(prompt.c_str(), on_line);
  type_ahead();
  while (!finished) {
    if (signals.wait_for_key()) take_key();
    if (!finished && act_on_signals()) return LineEnd::interrupted;
  }
  if (!entered) {
    if (!marks_pastes()) std::fputc('\n', rl_outstream);  // else readline did
    return LineEnd::end_of_input;
  }
  line = *entered;
  return LineEnd::entered;
}

LineEnd LineEditor::read(const std::string& prompt, std::string& line) {
  if (interactive_) return read_terminal(prompt, line);
  char* text = nullptr;
  std::size_t room = 0;
  const ssize_t length = getline(&text, &room, stdin);
  const std::unique_ptr<char, decltype(&std::free)> owner(text, std::free);
  if (length < 0) return LineEnd::end_of_input;
  line.assign(text, static_cast<std::size_t>(length));
  if (line.ends_with('\n')) line.pop_back();
  return LineEnd::entered;
}

}  // namespace meander::repl
