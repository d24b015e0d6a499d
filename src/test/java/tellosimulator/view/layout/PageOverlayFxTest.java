package tellosimulator.view.layout;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.settle;

import atlantafx.base.theme.PrimerLight;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javafx.application.Application;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.Tab;
import javafx.scene.control.TabPane;
import javafx.scene.control.TextArea;
import javafx.scene.control.TextField;
import javafx.scene.input.Clipboard;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.StackPane;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import tellosimulator.sim.SimConfig;
import tellosimulator.view.pilot.FlownWindow;
import tellosimulator.view.pilot.SteeringKey;
import tellosimulator.view.testing.StageExtension;

@ExtendWith(StageExtension.class)
class PageOverlayFxTest {

  private final List<WindowKey> pressed = new ArrayList<>();
  private FlownWindow window;
  private PageOverlay overlay;

  @Start
  void start(Stage stage) {
    Application.setUserAgentStylesheet(new PrimerLight().getUserAgentStylesheet());
    window = new FlownWindow(SimConfig.DEFAULT);
    overlay = new PageOverlay(window.context());
    TextField field = new TextField();
    field.setId("field");
    StackPane below = new StackPane(field);
    Scene scene = new Scene(new StackPane(below, overlay), 1280, 800);
    KeyBindings keys = new KeyBindings();
    for (WindowKey key : WindowKey.values()) {
      keys.on(key, () -> pressed.add(key));
    }
    keys.on(WindowKey.HELP, overlay::toggleHelp).install(scene);
    stage.setScene(scene);
    stage.show();
    overlay.getParent().requestFocus();
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void theHelpListsEveryKeyInBothLanguages(FxRobot robot) {
    robot.type(KeyCode.F1);
    assertThat(robot.lookup("#help-page").query().isVisible()).isTrue();

    for (Locale language : List.of(Locale.ENGLISH, Locale.GERMAN)) {
      robot.interact(() -> window.context().language().localeProperty().set(language));
      for (WindowKey key : WindowKey.values()) {
        assertThat(label(robot, "#help-" + key.textKey()).getText()).isNotBlank();
      }
      for (SteeringKey key : SteeringKey.values()) {
        assertThat(label(robot, "#help-steering-" + key.textKey()).getText()).isNotBlank();
      }
    }
    assertThat(label(robot, "#help-key-fit").getText()).isEqualTo("9 oder Pos1");
    assertThat(label(robot, "#help-steering-key-take-off-or-land").getText())
        .isEqualTo("Leertaste");
  }

  @Test
  void nothingOfTheHelpIsCutOff(FxRobot robot) {
    robot.type(KeyCode.F1);

    for (Locale language : List.of(Locale.ENGLISH, Locale.GERMAN)) {
      robot.interact(() -> window.context().language().localeProperty().set(language));
      TabPane pages = robot.from(robot.lookup("#help-page")).lookup(".tab-pane").query();
      for (Tab page : pages.getTabs()) {
        robot.interact(() -> pages.getSelectionModel().select(page));
        settle();
        for (Node node : page.getContent().lookupAll(".label")) {
          Label label = (Label) node;
          assertThat(label.getWidth()).as(label.getText()).isPositive();
          assertThat(label.getHeight())
              .as(label.getText())
              .isGreaterThanOrEqualTo(label.prefHeight(label.getWidth()) - 1);
        }
      }
    }
  }

  @Test
  void theFirstStepsNameTheAddress(FxRobot robot) {
    window.setCommandPort(8879);

    robot.type(KeyCode.F1);

    assertThat(label(robot, "#help-step-2").getText()).contains("127.0.0.1:8879");
  }

  @Test
  void theFirstProgramFliesTheSelectedDroneAndIsCopiedWithTheKeyboard(FxRobot robot) {
    window.setCommandPort(8881);
    robot.type(KeyCode.F1);
    assertThat(label(robot, "#help-program").getText())
        .contains("host = \"127.0.0.1\"", "tello.address = (host, 8881)");
    Button copy = robot.lookup("#help-copy-program").queryButton();
    assertThat(copy.getAccessibleText()).isEqualTo("Copy the program");

    for (int i = 0; i < 20 && !copy.isFocused(); i++) {
      robot.type(KeyCode.TAB);
    }
    robot.type(KeyCode.SPACE);

    String[] copied = new String[1];
    robot.interact(() -> copied[0] = Clipboard.getSystemClipboard().getString());
    assertThat(copied[0]).isEqualTo(label(robot, "#help-program").getText());
  }

  @Test
  void theFirstStepsCallButtonsAsTheyAreCalled(FxRobot robot) {
    robot.type(KeyCode.F1);

    assertThat(label(robot, "#help-step-1").getText()).startsWith("1  Press Start Drone:");
    robot.interact(() -> window.context().language().localeProperty().set(Locale.GERMAN));
    assertThat(label(robot, "#help-step-1").getText()).startsWith("1  Auf „Drohne einschalten“");
    assertThat(label(robot, "#help-step-4").getText()).contains("„Demoflug“", "„Tastatur“");
    assertThat(label(robot, "#help-steering-note").getText()).contains("„Tastatur“");
  }

  @Test
  void theHelpIsClosedByEscButtonAndF1(FxRobot robot) {
    robot.type(KeyCode.F1, KeyCode.ESCAPE);
    assertThat(overlay.isVisible()).isFalse();

    robot.type(KeyCode.F1).clickOn("#help-close");
    assertThat(overlay.isVisible()).isFalse();

    robot.type(KeyCode.F1, KeyCode.F1);
    assertThat(overlay.isVisible()).isFalse();
  }

  @Test
  void theFocusGoesBackToWhereItWas(FxRobot robot) {
    robot.clickOn("#field").type(KeyCode.F1);
    assertThat(robot.lookup("#field").query().isFocused()).isFalse();

    robot.type(KeyCode.ESCAPE);

    assertThat(robot.lookup("#field").query().isFocused()).isTrue();
  }

  @Test
  void theAboutPageShowsVersionsAndEachLicense(FxRobot robot) {
    robot.interact(overlay::showAbout);
    assertThat(label(robot, "#about-title").getText()).isEqualTo("Tello Simulator development");
    assertThat(label(robot, "#about-versions").getText())
        .contains(System.getProperty("java.version"), System.getProperty("javafx.version"));

    ListView<?> documents = robot.lookup("#about-documents").queryListView();
    assertThat(documents.getItems().stream().map(String::valueOf))
        .contains(
            "META-INF/NOTICE",
            "META-INF/LICENSE",
            "META-INF/licenses/GPL-2.0-with-classpath-exception.txt",
            "META-INF/licenses/EPL-2.0.md",
            "META-INF/licenses/MIT-slf4j.txt");
    for (int i = 0; i < documents.getItems().size(); i++) {
      int row = i;
      robot.interact(() -> documents.getSelectionModel().select(row));
      assertThat(robot.lookup("#about-text").queryAs(TextArea.class).getText())
          .as("%s", documents.getItems().get(i))
          .hasSizeGreaterThan(500)
          .containsPattern(i == 0 ? "OpenJFX" : "(?i)license|redistributions|third-party");
    }
    robot.clickOn("#about-close");
    assertThat(overlay.isVisible()).isFalse();
  }

  @ParameterizedTest
  @EnumSource(
      value = WindowKey.class,
      names = {
        "HELP",
        "GALLERY",
        "OPEN_SCENARIO",
        "SAVE_SCENARIO",
        "SAVE_SCENARIO_AS",
        "RELOAD_SCENARIO",
        "AGAIN",
        "SEARCH_LOG",
        "COMMANDS",
        "QUIT",
        "PROJECTOR",
        "NEXT_GROUP",
        "FIT"
      },
      mode = EnumSource.Mode.EXCLUDE)
  void keysAct(WindowKey key, FxRobot robot) {
    robot.type(
        KeyCode.getKeyCode(key.symbols(window.context().language().messages(WindowKey.class))));

    assertThat(pressed).containsExactly(key);
  }

  @Test
  void keysWithControlAct(FxRobot robot) {
    robot.press(KeyCode.CONTROL);
    robot.type(KeyCode.O, KeyCode.S, KeyCode.R, KeyCode.N, KeyCode.F, KeyCode.K);
    robot.press(KeyCode.SHIFT).type(KeyCode.S, KeyCode.N).release(KeyCode.SHIFT);
    robot.release(KeyCode.CONTROL).type(KeyCode.HOME);

    assertThat(pressed)
        .containsExactly(
            WindowKey.OPEN_SCENARIO,
            WindowKey.SAVE_SCENARIO,
            WindowKey.RELOAD_SCENARIO,
            WindowKey.AGAIN,
            WindowKey.SEARCH_LOG,
            WindowKey.COMMANDS,
            WindowKey.SAVE_SCENARIO_AS,
            WindowKey.NEXT_GROUP,
            WindowKey.FIT);
  }

  @Test
  void aKeyWithShiftIsAnotherKey(FxRobot robot) {
    robot.press(KeyCode.SHIFT).type(KeyCode.F11).release(KeyCode.SHIFT).type(KeyCode.F11);

    assertThat(pressed).containsExactly(WindowKey.PROJECTOR, WindowKey.FULL_SCREEN);
  }

  @Test
  void textFieldsKeepWhatCanBeTyped(FxRobot robot) {
    robot.clickOn("#field").type(KeyCode.DIGIT1, KeyCode.HOME, KeyCode.F7);
    robot.press(KeyCode.CONTROL).type(KeyCode.F).release(KeyCode.CONTROL);

    assertThat(robot.lookup("#field").queryAs(TextField.class).getText()).isEqualTo("1");
    assertThat(pressed).containsExactly(WindowKey.TRAIL, WindowKey.SEARCH_LOG);
  }

  private static Label label(FxRobot robot, String id) {
    return robot.lookup(id).queryAs(Label.class);
  }
}
