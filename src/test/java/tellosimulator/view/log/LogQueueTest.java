package tellosimulator.view.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import tellosimulator.controller.FlightEvent;
import tellosimulator.math.Vec3;
import tellosimulator.sim.SimEvent;
import tellosimulator.time.SimTime;
import tellosimulator.view.text.Language;
import tellosimulator.words.Phrase;
import tellosimulator.world.Surface;

class LogQueueTest {

  private final Language language = new Language(Locale.ENGLISH);
  private final LogQueue logQueue = new LogQueue();

  @Test
  void eventsComeOutInOrderWithTimeLevelAndDrone() {
    SimTime time = SimTime.ZERO.next();
    logQueue.event(new SimEvent.DroneFlight(time, 2, new FlightEvent.TookOff()));
    logQueue.event(
        new SimEvent.DroneFlight(
            time.next(), 2, new FlightEvent.Crashed(Surface.CEILING, 2, 0, Vec3.ZERO)));

    List<LogLine> lines = logQueue.drain();

    assertThat(lines).extracting(LogLine::time).containsExactly(time, time.next());
    assertThat(lines).extracting(LogLine::level).containsExactly(LogLevel.INFO, LogLevel.ERROR);
    assertThat(lines).extracting(line -> line.drone().orElseThrow()).containsOnly(2);
    assertThat(words(lines)).startsWith("took off");
    assertThat(logQueue.drain()).as("each line comes out once").isEmpty();
  }

  @Test
  void theGreetingDoesNotAskForWhatIsDone() {
    logQueue.welcome(true);
    logQueue.welcome(false);

    assertThat(words(logQueue.drain()))
        .singleElement()
        .asString()
        .startsWith("Welcome. Start your");
  }

  @Test
  void theGreetingAsksToSwitchOn() {
    logQueue.welcome(false);

    assertThat(words(logQueue.drain())).singleElement().asString().contains("Switch the drone on");
  }

  @Test
  void whatFindsNoRoomIsCountedAndSaid() {
    for (int i = 0; i < LogQueue.CAPACITY + 1234; i++) {
      logQueue.event(new SimEvent.WorldChanged(SimTime.ZERO, Phrase.of("change %d", i)));
    }

    List<String> words = words(logQueue.drain());

    assertThat(words).hasSize(LogQueue.CAPACITY + 1);
    assertThat(words.get(LogQueue.CAPACITY - 1)).isEqualTo("change " + (LogQueue.CAPACITY - 1));
    assertThat(words.get(LogQueue.CAPACITY)).startsWith("1,234 lines were lost here");
    assertThat(logQueue.drain()).as("said once").isEmpty();
  }

  @Test
  void linesOfTheWindowSpeakTheLanguageThatIsChosen() {
    logQueue.note(LogLevel.WARN, "lost-one", 1);
    LogLine line = logQueue.drain().get(0);

    assertThat(line.level()).isEqualTo(LogLevel.WARN);
    assertThat(line.words(language)).startsWith("One line was lost");
    language.localeProperty().set(Locale.GERMAN);
    assertThat(line.words(language)).startsWith("Eine Zeile ging");
  }

  @Test
  void severalThreadsCanWriteWithoutLosingALine() throws InterruptedException {
    int writers = 4;
    int each = LogQueue.CAPACITY / writers;
    CountDownLatch start = new CountDownLatch(1);
    List<Thread> threads = new ArrayList<>();
    for (int i = 0; i < writers; i++) {
      Thread thread = new Thread(() -> write(start, each));
      thread.start();
      threads.add(thread);
    }
    start.countDown();
    for (Thread thread : threads) {
      thread.join();
    }

    assertThat(logQueue.drain()).hasSize(writers * each);
  }

  private void write(CountDownLatch start, int lines) {
    try {
      start.await();
    } catch (InterruptedException e) {
      throw new AssertionError("nobody interrupts", e);
    }
    for (int i = 0; i < lines; i++) {
      logQueue.event(new SimEvent.WorldChanged(SimTime.ZERO, Phrase.of("change")));
    }
  }

  private List<String> words(List<LogLine> lines) {
    return lines.stream().map(line -> line.words(language)).toList();
  }
}
