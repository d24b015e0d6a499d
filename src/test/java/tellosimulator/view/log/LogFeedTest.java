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

class LogFeedTest {

  private final Language language = new Language(Locale.ENGLISH);
  private final LogFeed feed = new LogFeed();

  @Test
  void eventsComeOutInOrderWithTimeLevelAndDrone() {
    SimTime time = SimTime.ZERO.next();
    feed.event(new SimEvent.DroneFlight(time, 2, new FlightEvent.TookOff()));
    feed.event(
        new SimEvent.DroneFlight(
            time.next(), 2, new FlightEvent.Crashed(Surface.CEILING, 2, 0, Vec3.ZERO)));

    List<LogLine> lines = feed.drain();

    assertThat(lines).extracting(LogLine::time).containsExactly(time, time.next());
    assertThat(lines).extracting(LogLine::level).containsExactly(LogLevel.INFO, LogLevel.ERROR);
    assertThat(lines).extracting(LogLine::drone).containsOnly(2);
    assertThat(words(lines)).startsWith("took off");
    assertThat(feed.drain()).as("each line comes out once").isEmpty();
  }

  @Test
  void theGreetingDoesNotAskForWhatIsDone() {
    feed.welcome(true);
    feed.welcome(false);

    assertThat(words(feed.drain())).singleElement().asString().startsWith("Welcome. Start your");
  }

  @Test
  void theGreetingAsksToSwitchOn() {
    feed.welcome(false);

    assertThat(words(feed.drain())).singleElement().asString().contains("Switch the drone on");
  }

  @Test
  void whatFindsNoRoomIsCountedAndSaid() {
    for (int i = 0; i < LogFeed.CAPACITY + 1234; i++) {
      feed.event(new SimEvent.WorldChanged(SimTime.ZERO, Phrase.of("change %d", i)));
    }

    List<String> words = words(feed.drain());

    assertThat(words).hasSize(LogFeed.CAPACITY + 1);
    assertThat(words.get(LogFeed.CAPACITY - 1)).isEqualTo("change " + (LogFeed.CAPACITY - 1));
    assertThat(words.get(LogFeed.CAPACITY)).startsWith("1,234 lines were lost here");
    assertThat(feed.drain()).as("said once").isEmpty();
  }

  @Test
  void linesOfTheWindowSpeakTheLanguageThatIsChosen() {
    feed.note(LogLevel.WARN, "lost", 1);
    LogLine line = feed.drain().get(0);

    assertThat(line.level()).isEqualTo(LogLevel.WARN);
    assertThat(line.words(language)).startsWith("One line was lost");
    language.localeProperty().set(Locale.GERMAN);
    assertThat(line.words(language)).startsWith("Eine Zeile ging");
  }

  @Test
  void severalThreadsCanWriteWithoutLosingALine() throws InterruptedException {
    int writers = 4;
    int each = LogFeed.CAPACITY / writers;
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

    assertThat(feed.drain()).hasSize(writers * each);
  }

  private void write(CountDownLatch start, int lines) {
    try {
      start.await();
    } catch (InterruptedException e) {
      throw new AssertionError("nobody interrupts", e);
    }
    for (int i = 0; i < lines; i++) {
      feed.event(new SimEvent.WorldChanged(SimTime.ZERO, Phrase.of("change")));
    }
  }

  private List<String> words(List<LogLine> lines) {
    return lines.stream().map(line -> line.words(language)).toList();
  }
}
