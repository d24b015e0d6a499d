package tellosimulator.view.app;

import java.io.IOException;
import java.nio.file.Path;
import tellosimulator.scenario.Diagnostic;
import tellosimulator.scenario.ScenarioDocument;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.scenario.ScenarioFile;
import tellosimulator.view.log.LogLevel;
import tellosimulator.view.log.LogQueue;

/** Writes scenarios to files and logs the outcome. Thread-safe. */
final class ScenarioWriter {

  private final LogQueue logQueue;

  ScenarioWriter(LogQueue logQueue) {
    this.logQueue = logQueue;
  }

  /** Writes a scenario and returns whether this succeeded. */
  boolean write(ScenarioDocument document, Path file) {
    try {
      ScenarioFile.write(document, file);
    } catch (IOException e) {
      notSaved(file, e);
      return false;
    }
    say(LogLevel.INFO, "scenario-saved", file);
    if (document.kept() != ScenarioDocument.Preserved.ALL) {
      say(LogLevel.WARN, "scenario-written-anew", file);
    }
    try {
      ScenarioFile.read(file);
    } catch (ScenarioException e) { // for example, a goal refers to a removed gate
      e.diagnostics().forEach(this::warn);
    }
    return true;
  }

  private void warn(Diagnostic diagnostic) {
    logQueue.say(LogLevel.WARN, language -> diagnostic.in(language.translation()));
  }

  /** Logs why a scenario could not be written. */
  void notSaved(Path file, IOException e) {
    logQueue.say(
        LogLevel.ERROR,
        language ->
            language
                .messages(ScenarioWriter.class)
                .now("scenario-not-saved", file, language.reason(e)));
  }

  private void say(LogLevel level, String key, Path file) {
    logQueue.say(level, language -> language.messages(ScenarioWriter.class).now(key, file));
  }
}
