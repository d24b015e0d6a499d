package tellosimulator.view.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javafx.collections.ListChangeListener;
import org.junit.jupiter.api.Test;
import tellosimulator.command.Peer;
import tellosimulator.command.Request;
import tellosimulator.time.SimTime;
import tellosimulator.view.text.Language;
import tellosimulator.words.Phrase;

class LogModelTest {

  private static final int CAPACITY = 2000;

  private static final Peer PEER =
      new Peer(new InetSocketAddress(9000), new InetSocketAddress(8889));

  private final Language language = new Language(Locale.ENGLISH);
  private final LogModel model = new LogModel(CAPACITY, this::words);

  @Test
  void theOldestLinesFallOutWhenThereAreTooMany() {
    model.append(lines(0, 1500));
    assertThat(model.append(lines(1500, 700))).as("1500 + 700 - 2000").isEqualTo(200);

    assertThat(model.size()).isEqualTo(CAPACITY);
    assertThat(words()).hasSize(CAPACITY).startsWith("line 200", "line 201").endsWith("line 2199");
  }

  @Test
  void manyMoreLinesThanThereIsRoomForLeaveTheNewest() {
    model.append(lines(0, 10));
    model.append(lines(10, 3 * CAPACITY));

    assertThat(words()).hasSize(CAPACITY).startsWith("line 4010").endsWith("line 6009");
  }

  @Test
  void onlyLinesOfTheLevelAndThoseThatMatterMoreAreShown() {
    for (LogLevel level : LogLevel.values()) {
      model.append(List.of(line(level, level.name())));
    }
    model.setLevel(LogLevel.WARN);
    assertThat(words()).containsExactly("ERROR", "WARN");

    model.append(List.of(line(LogLevel.DEBUG, "more"), line(LogLevel.ERROR, "worse")));
    assertThat(words()).as("the filter holds for new lines").endsWith("WARN", "worse");

    model.setLevel(LogLevel.DEBUG);
    assertThat(words()).containsExactly("ERROR", "WARN", "INFO", "DEBUG", "more", "worse");
  }

  @Test
  void aSearchIgnoresUpperCaseAndTakesSignsLiterally() {
    model.append(
        List.of(
            line(LogLevel.INFO, "`BATTERY?` answered `87`"),
            line(LogLevel.INFO, "batteryX"),
            line(LogLevel.INFO, "Überschlag")));

    model.setText("battery?");
    assertThat(words()).containsExactly("`BATTERY?` answered `87`");
    model.setText("ÜBER");
    assertThat(words()).containsExactly("Überschlag");
    model.setText("");
    assertThat(words()).hasSize(3);
  }

  @Test
  void aSearchFindsTheWordsOfTheLanguageThatIsChosen() {
    model.append(
        List.of(
            new LogLine(
                SimTime.ZERO,
                LogLevel.INFO,
                LogLine.About.ALL,
                in -> in.locale().equals(Locale.GERMAN) ? "gelandet" : "landed")));
    model.setText("landed");
    assertThat(words()).containsExactly("landed");

    language.localeProperty().set(Locale.GERMAN);
    model.wordsChanged();
    assertThat(words()).isEmpty();
    model.setText("gelandet");
    assertThat(words()).containsExactly("gelandet");
  }

  @Test
  void linesThatFallOutAreTakenFromTheShownOnesToo() {
    model.append(lines(0, CAPACITY));
    model.setText("5");
    int before = model.shown().size();

    assertThat(model.append(List.of(line(LogLevel.INFO, "x"))))
        .as("`line 0` was not shown")
        .isZero();
    assertThat(model.append(lines(0, 5))).as("`line 5` was").isEqualTo(1);
    assertThat(model.shown()).hasSize(before - 1);
    assertThat(words()).startsWith("line 15");
  }

  @Test
  void aListThatFollowsTheChangesEndsUpTheSame() {
    List<LogRow> copy = new ArrayList<>();
    model.shown().addListener((ListChangeListener<LogRow>) change -> repeat(change, copy));

    model.append(lines(0, 1990));
    model.append(lines(1990, 30));
    model.setText("7");
    model.append(lines(0, 900));
    model.setLevel(LogLevel.ERROR);
    model.append(List.of(line(LogLevel.ERROR, "7")));
    model.setLevel(LogLevel.DEBUG);
    model.setText("");

    assertThat(copy).hasSize(CAPACITY).isEqualTo(List.copyOf(model.shown()));
    model.clear();
    assertThat(copy).isEmpty();
    assertThat(model.size()).isZero();
  }

  @Test
  void theAnswerIsInTheRowOfItsCommand() {
    model.append(List.of(received(1, 1, "takeoff"), received(2, 1, "takeoff")));
    model.append(List.of(line(LogLevel.INFO, "took off"), answered(2, 1, 3, "takeoff")));

    assertThat(words()).containsExactly("takeoff", "takeoff | takeoff: ok", "took off");
    assertThat(model.shown().get(1).duration()).hasValue(3);
    assertThat(model.shown().get(0).outcome()).isEmpty();
    assertThat(model.lines().stream().map(line -> line.words(language)))
        .as("in the order in which they came")
        .containsExactly("takeoff", "takeoff", "took off", "takeoff: ok");
  }

  @Test
  void equalCommandsAreToldApartByTheirNumbers() {
    model.append(List.of(received(1, 7, "up 50"), received(1, 8, "up 50")));
    model.append(List.of(refused(8, "up 50"), answered(1, 7, 4, "up 50")));

    assertThat(words()).containsExactly("up 50 | up 50: ok", "up 50 | up 50: error");
  }

  @Test
  void bothRepliesToAStopAreInItsRow() {
    model.append(List.of(received(1, 3, "stop"), received(1, 4, "stop")));
    model.append(List.of(answered(1, 3, 0, "stop"), answered(1, 3, 1, "stop")));

    assertThat(words()).containsExactly("stop | stop: ok | stop: ok", "stop");
  }

  @Test
  void anAnswerWithoutACommandIsARowOfItsOwn() {
    model.append(List.of(answered(1, 1, 1, "stop"), received(1, 2, "rc 0 0 0 0")));
    model.append(List.of(received(1, 3, "rc 0 0 0 0")));

    assertThat(words()).containsExactly("stop: ok", "rc 0 0 0 0", "rc 0 0 0 0");
    assertThat(model.shown().get(0).duration()).isEmpty();
  }

  @Test
  void aDetailThatIsRefusedAppearsAtItsPlace() {
    model.setLevel(LogLevel.INFO);
    model.append(List.of(received(1, 1, "battery?"), line(LogLevel.INFO, "later")));
    assertThat(words()).containsExactly("later");

    model.append(List.of(refused(1, "battery?")));

    assertThat(words()).containsExactly("battery? | battery?: error", "later");
  }

  @Test
  void rowsOfAnotherDroneAreLeftOut() {
    model.append(
        List.of(received(1, 1, "up 20"), received(2, 1, "up 30"), line(LogLevel.INFO, "paused")));

    model.setDrone(OptionalInt.of(2));
    assertThat(words()).containsExactly("up 30", "paused");
    model.append(List.of(answered(1, 1, 1, "up 20"), answered(2, 1, 1, "up 30")));
    assertThat(words()).containsExactly("up 30 | up 30: ok", "paused");
    model.setDrone(OptionalInt.empty());
    assertThat(words()).hasSize(3);
  }

  @Test
  void anAnswerThatComesAfterItsCommandFellOutIsARowOfItsOwn() {
    model.append(List.of(received(1, 1, "up 20")));
    model.append(lines(0, CAPACITY));

    model.append(List.of(answered(1, 1, 1, "up 20")));

    assertThat(words()).hasSize(CAPACITY).endsWith("up 20: ok");
  }

  private static LogLine received(int drone, int number, String command) {
    LogLevel level = command.endsWith("?") ? LogLevel.DEBUG : LogLevel.INFO;
    return exchange(
        SimTime.ZERO, level, drone, new Request(number, PEER, command), Optional.empty());
  }

  private static LogLine answered(int drone, int number, int seconds, String command) {
    return exchange(
        new SimTime(seconds * 1_000_000_000L),
        LogLevel.INFO,
        drone,
        new Request(number, PEER, command),
        Optional.of(new LogLine.Outcome("ok", Optional.empty())));
  }

  private static LogLine refused(int number, String command) {
    return exchange(
        SimTime.ZERO,
        LogLevel.WARN,
        1,
        new Request(number, PEER, command),
        Optional.of(new LogLine.Outcome("error", Optional.of(Phrase.of("because")))));
  }

  private static LogLine exchange(
      SimTime time, LogLevel level, int drone, Request request, Optional<LogLine.Outcome> outcome) {
    String words = request.text() + outcome.map(end -> ": " + end.reply()).orElse("");
    return new LogLine(
        time,
        level,
        LogLine.About.drone(drone, false),
        language -> words,
        Optional.of(new LogLine.Exchange(request, outcome)));
  }

  private static void repeat(
      ListChangeListener.Change<? extends LogRow> change, List<LogRow> copy) {
    while (change.next()) {
      for (LogRow removed : change.getRemoved()) {
        assertThat(copy.remove(change.getFrom())).isEqualTo(removed);
      }
      copy.addAll(change.getFrom(), change.getAddedSubList());
    }
  }

  private static List<LogLine> lines(int first, int count) {
    return IntStream.range(first, first + count)
        .mapToObj(i -> line(LogLevel.INFO, "line " + i))
        .toList();
  }

  private static LogLine line(LogLevel level, String words) {
    return new LogLine(SimTime.ZERO, level, LogLine.About.ALL, language -> words);
  }

  private List<String> words() {
    return model.shown().stream().map(this::words).toList();
  }

  private String words(LogRow row) {
    return row.lines().stream()
        .map(line -> line.words(language))
        .collect(Collectors.joining(" | "));
  }
}
