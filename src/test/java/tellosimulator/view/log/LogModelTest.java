package tellosimulator.view.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import javafx.collections.ListChangeListener;
import org.junit.jupiter.api.Test;
import tellosimulator.time.SimTime;
import tellosimulator.view.text.Language;

class LogModelTest {

  private static final int CAPACITY = 2000;

  private final Language language = new Language(Locale.ENGLISH);
  private final LogModel model = new LogModel(CAPACITY, line -> line.words(language));

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
    List<LogLine> copy = new ArrayList<>();
    model.shown().addListener((ListChangeListener<LogLine>) change -> repeat(change, copy));

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

  private static void repeat(
      ListChangeListener.Change<? extends LogLine> change, List<LogLine> copy) {
    while (change.next()) {
      for (LogLine removed : change.getRemoved()) {
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
    return model.shown().stream().map(line -> line.words(language)).toList();
  }
}
