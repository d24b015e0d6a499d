package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.Control;
import javafx.scene.control.Labeled;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.sim.SimConfig;
import tellosimulator.view.testing.QuickRobot;

/** All texts of the window follow its language immediately. */
class TranslatedWindowFxTest {

  /** The texts that are the same in English and German; the last one is the toolkit's. */
  private static final Set<String> SAME_IN_BOTH =
      Set.of(
          "Yaw °",
          "Pitch °",
          "Roll °",
          "Start X cm",
          "Start Y cm",
          "X cm",
          "Y cm",
          "Z cm",
          "Radius cm",
          "Video",
          "−60 s",
          "Pause",
          "Plan",
          "Wind",
          "0 cm/s",
          "live",
          "English",
          "Deutsch",
          "Tello",
          "RoboMaster TT: SDK 3.0",
          "Overflow button");

  /** Numbers, keys and short names, which are the same in all languages. */
  private static final Pattern NO_WORDS = Pattern.compile("[^a-zA-Z]*[A-Z]{0,3}[^a-zA-Z]*");

  @TempDir private Path folder;
  private WholeWindow window;

  @BeforeEach
  void open() {
    window = WholeWindow.open(SimConfig.DEFAULT, folder.resolve("settings"));
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void eachPartFollowsTheMenu() {
    window.choose("language", "language-de");

    assertThat(window.text("camera")).isEqualTo("Startansicht");
    assertThat(window.text("reset")).isEqualTo("Drohne zurück");
    assertThat(window.text("power")).isEqualTo("Drohne einschalten");
    assertThat(window.text("demo-flight")).isEqualTo("Demoflug");
    assertThat(window.text("log-clear")).isEqualTo("Leeren");
    waitUntil(() -> window.log().stream().anyMatch(line -> line.startsWith("Willkommen")));

    window.choose("language", "language-en");
    assertThat(window.text("power")).isEqualTo("Start Drone");
    waitUntil(() -> window.log().stream().anyMatch(line -> line.startsWith("Welcome")));
  }

  @Test
  void noTextStaysEnglish() {
    new QuickRobot().type(KeyCode.F1, KeyCode.F1);
    IdentityHashMap<Object, List<String>> english = texts(Locale.ENGLISH);
    IdentityHashMap<Object, List<String>> german = texts(Locale.GERMAN);

    List<String> same = new ArrayList<>();
    english.forEach(
        (owner, texts) -> {
          for (String text : texts) {
            if (german.getOrDefault(owner, List.of()).contains(text)
                && !NO_WORDS.matcher(text).matches()
                && !SAME_IN_BOTH.contains(text)
                && !text.startsWith("from djitellopy import Tello")) { // a program
              same.add(text);
            }
          }
        });
    assertThat(english).hasSizeGreaterThan(120);
    assertThat(same).isEmpty();
  }

  /** Returns the text and the tooltip of each node of the window. */
  private IdentityHashMap<Object, List<String>> texts(Locale locale) {
    window.change(() -> window.context().language().localeProperty().set(locale));
    window.passFrames(3);
    return onFxThread(
        () -> {
          IdentityHashMap<Object, List<String>> all = new IdentityHashMap<>();
          collect(window.stage().getScene().getRoot(), all);
          return all;
        });
  }

  private static void collect(Node node, IdentityHashMap<Object, List<String>> all) {
    if (node instanceof Labeled labeled) {
      add(all, node, labeled.getText());
    }
    if (node instanceof TextInputControl input) {
      add(all, node, input.getPromptText());
    }
    if (node instanceof Control control && control.getTooltip() != null) {
      add(all, control.getTooltip(), control.getTooltip().getText());
    }
    if (node instanceof MenuButton button) {
      button.getItems().forEach(item -> collect(item, all));
    }
    add(all, node, node.getAccessibleText());
    if (node instanceof Parent parent) {
      parent.getChildrenUnmodifiable().forEach(child -> collect(child, all));
    }
  }

  private static void collect(MenuItem item, IdentityHashMap<Object, List<String>> all) {
    add(all, item, item.getText());
    if (item instanceof Menu menu) {
      menu.getItems().forEach(part -> collect(part, all));
    }
  }

  private static void add(IdentityHashMap<Object, List<String>> all, Object owner, String text) {
    if (text != null && !text.isBlank()) {
      all.computeIfAbsent(owner, any -> new ArrayList<>()).add(text);
    }
  }
}
