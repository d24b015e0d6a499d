package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.ToggleButton;
import javafx.scene.image.PixelReader;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.Border;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import javafx.scene.text.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.testfx.api.FxRobot;
import tellosimulator.view.layout.Theme;
import tellosimulator.view.testing.QuickRobot;

/**
 * All texts of the window are legible in both themes: they are large enough, and their colour
 * contrasts with the background, which is taken from a picture of the window. The control with the
 * focus and the one under the mouse are highlighted.
 */
class LegibleWindowFxTest {

  /** Minimum font size [px]. Decided. */
  private static final double SMALLEST = 12;

  /** Documented: WCAG 2.1, 1.4.3, for text that is not large. */
  private static final double LEAST_CONTRAST = 4.5;

  /** Documented: WCAG 2.1, 1.4.11, for focus indicators. */
  private static final double LEAST_CONTRAST_OF_RINGS = 3;

  /** Error of the contrast that results from the whole colour values of pictures. */
  private static final double ROUNDING = 0.05;

  private final FxRobot robot = new QuickRobot();
  @TempDir private Path folder;
  private WholeWindow window;

  @BeforeEach
  void open() {
    window = WholeWindow.ofDrones(3, folder);
  }

  @AfterEach
  void close() {
    window.close();
  }

  @ParameterizedTest
  @EnumSource(Theme.class)
  void eachTextIsLargeEnoughAndHasContrast(Theme theme) {
    window.change(() -> window.state().themeProperty().set(theme));
    window.change(this::unfold);
    assertThat(illegible("simulator-pane")).as("while all is off").isEmpty();
    window.change(() -> window.find("network-controls", ScrollPane.class).setVvalue(1));
    window.change(() -> window.find("simulator-controls", ScrollPane.class).setVvalue(1));
    assertThat(illegible("simulator-pane")).as("the rest of the panels").isEmpty();

    window.switchOn();
    assertThat(window.fly("command", "flip f")).startsWith("error");
    waitUntil(() -> window.log().stream().anyMatch(words -> words.contains("flip f")));
    robot.clickOn("#keyboard-flight");
    assertThat(illegible("simulator-pane")).as("while all is on").isEmpty();

    robot.type(KeyCode.F10);
    assertThat(illegible("plan-pane")).isEmpty();
    robot.type(KeyCode.ESCAPE).type(KeyCode.F1);
    assertThat(illegible("help-page")).isEmpty();
    robot.type(KeyCode.ESCAPE).clickOn("#settings").clickOn("#about");
    assertThat(illegible("about-page")).isEmpty();
  }

  @Test
  void whatIsReachedByKeyboardHasARing() {
    for (Theme theme : Theme.values()) {
      assertRing(theme);
    }
  }

  private void assertRing(Theme theme) {
    window.change(() -> window.state().themeProperty().set(theme));
    window.change(() -> window.find("power").requestFocus());
    assertThat(border("power")).as("as a click gives the focus").isNull();

    robot.type(KeyCode.TAB);

    Border ring =
        onFxThread(() -> ((Region) window.stage().getScene().getFocusOwner()).getBorder());
    assertThat(ring.getStrokes()).hasSize(1);
    assertThat(ring.getStrokes().get(0).getWidths().getTop()).isEqualTo(2);
    assertThat(ring.getInsets().getTop()).as("nothing moves").isZero();
    Color color = (Color) ring.getStrokes().get(0).getTopStroke();
    Color behind = theme == Theme.LIGHT ? Color.web("#f6f8fa") : Color.web("#161b22");
    assertThat(contrast(color, behind)).isGreaterThan(LEAST_CONTRAST_OF_RINGS);
  }

  @Test
  void whatTheMouseIsOverHasALine() {
    for (String over :
        List.of("power", "help", "show-log", "time-factor", "log-search", "demo-flight")) {
      robot.moveTo("#" + over);
      waitUntil(() -> border(over) != null);
      assertThat(border(over).getInsets().getTop()).as("nothing moves").isZero();
    }
  }

  private void unfold() {
    for (Node head : window.stage().getScene().getRoot().lookupAll(".card-head")) {
      if (!((ToggleButton) head).isSelected()) {
        ((ToggleButton) head).fire();
      }
    }
  }

  private Border border(String id) {
    return onFxThread(() -> ((Region) window.find(id)).getBorder());
  }

  /** Returns the illegible texts of a part, with the reasons. */
  private List<String> illegible(String part) {
    window.passFrames(5);
    WritableImage picture = window.picture();
    return onFxThread(
        () -> {
          List<String> problems = new ArrayList<>();
          List<Text> texts = new ArrayList<>();
          collect(window.find(part), texts);
          assertThat(texts).hasSizeGreaterThan(5);
          texts.forEach(text -> problem(text, picture).ifPresent(problems::add));
          return problems;
        });
  }

  private static void collect(Node node, List<Text> texts) {
    if (!node.isVisible()) {
      return;
    }
    if (node instanceof Text text && !text.getText().isBlank() && !isIcon(text)) {
      texts.add(text);
    }
    if (node instanceof Parent parent) {
      parent.getChildrenUnmodifiable().forEach(child -> collect(child, texts));
    }
  }

  private static boolean isIcon(Text text) {
    return text.getStyleClass().contains("ikonli-font-icon");
  }

  private static Optional<String> problem(Text text, WritableImage picture) {
    String what = "'" + text.getText() + "' in " + text.getParent();
    if (text.getFont().getSize() < SMALLEST) {
      return Optional.of(what + " has " + text.getFont().getSize() + " px");
    }
    double opacity = opacity(text);
    boolean dimmed = text.isDisabled() && opacity < 1;
    Bounds place = text.localToScene(text.getLayoutBounds());
    if (dimmed || !inSight(text, place, picture)) {
      return Optional.empty();
    }
    Color behind = mostFrequent(picture.getPixelReader(), place);
    Color ink = behind.interpolate((Color) text.getFill(), opacity);
    double contrast = contrast(ink, behind);
    return contrast + ROUNDING < LEAST_CONTRAST
        ? Optional.of(
            String.format(Locale.ROOT, "%s has %.2f:1, %s on %s", what, contrast, ink, behind))
        : Optional.empty();
  }

  private static double opacity(Node node) {
    double opacity = 1;
    for (Node each = node; each != null; each = each.getParent()) {
      opacity *= each.getOpacity();
    }
    return opacity;
  }

  /** Returns whether the node is not clipped. */
  private static boolean inSight(Node node, Bounds place, WritableImage picture) {
    boolean inSight =
        place.getMinX() >= 0
            && place.getMinY() >= 0
            && place.getMaxX() < picture.getWidth()
            && place.getMaxY() < picture.getHeight();
    for (Node each = node; each != null; each = each.getParent()) {
      inSight &=
          each.getClip() == null
              || each.localToScene(each.getClip().getBoundsInParent()).contains(place);
    }
    return inSight;
  }

  /** Returns the most frequent colour: the background covers more pixels than the text. */
  private static Color mostFrequent(PixelReader pixels, Bounds place) {
    Map<Integer, Integer> counts = new HashMap<>();
    for (int y = (int) place.getMinY(); y < place.getMaxY(); y++) {
      for (int x = (int) place.getMinX(); x < place.getMaxX(); x++) {
        counts.merge(pixels.getArgb(x, y), 1, Integer::sum);
      }
    }
    int argb = counts.entrySet().stream().max(Map.Entry.comparingByValue()).orElseThrow().getKey();
    return Color.rgb(argb >> 16 & 0xff, argb >> 8 & 0xff, argb & 0xff);
  }

  private static double contrast(Color one, Color other) {
    double brighter = Math.max(luminance(one), luminance(other));
    double darker = Math.min(luminance(one), luminance(other));
    return (brighter + 0.05) / (darker + 0.05);
  }

  private static double luminance(Color color) {
    return 0.2126 * linear(color.getRed())
        + 0.7152 * linear(color.getGreen())
        + 0.0722 * linear(color.getBlue());
  }

  private static double linear(double component) {
    return component <= 0.04045 ? component / 12.92 : Math.pow((component + 0.055) / 1.055, 2.4);
  }
}
