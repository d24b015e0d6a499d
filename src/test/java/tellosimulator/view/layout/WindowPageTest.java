package tellosimulator.view.layout;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import tellosimulator.testing.GeneratedPage;
import tellosimulator.view.pilot.SteeringKey;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/** {@code docs/window.md} has the same keys as the window's help. */
class WindowPageTest {

  private static final GeneratedPage PAGE = new GeneratedPage("window");

  private final Language language = new Language(Locale.ENGLISH);
  private final Messages messages = language.messages(HelpPage.class);
  private final Messages steering = language.messages(SteeringKey.class);

  @Test
  void theKeysAreThoseOfTheHelp() {
    String text =
        PAGE.template()
            .replace("{{views}}", keys(WindowKey::looks))
            .replace("{{window}}", keys(key -> !key.looks()))
            .replace("{{steering}}", table(Stream.of(SteeringKey.values()), this::steeringRow))
            .replace("{{mouse}}", table(HelpPage.MOUSE.stream(), this::mouseRow))
            .replace("{{plan}}", table(HelpPage.PLAN.stream(), this::mouseRow));

    PAGE.check(text, WindowPageTest.class);
  }

  private String keys(Predicate<WindowKey> chosen) {
    return table(
        Arrays.stream(WindowKey.values()).filter(chosen),
        key ->
            row(
                key.symbols(messages).replace("⌘ ", messages.now("ctrl") + "+"),
                messages.now(key.textKey())));
  }

  private String steeringRow(SteeringKey key) {
    String symbol =
        switch (key) {
          case FASTER -> messages.now("shift");
          case TAKE_OFF_OR_LAND -> messages.now("space");
          default -> key.symbol();
        };
    return row(symbol, steering.now(key.textKey()));
  }

  private String mouseRow(String key) {
    return row(messages.now(key), messages.now(key + "-does"));
  }

  private static <T> String table(Stream<T> items, Function<T, String> row) {
    return items.map(row).collect(Collectors.joining("\n", "| key | effect |\n|---|---|\n", ""));
  }

  private static String row(String key, String effect) {
    return "| " + key + " | " + effect + " |";
  }
}
