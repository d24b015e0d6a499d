package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import atlantafx.base.theme.Tweaks;
import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import javafx.scene.control.CustomMenuItem;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.layout.VBox;
import javafx.stage.FileChooser;
import javafx.stage.FileChooser.ExtensionFilter;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.scenario.Gallery;
import tellosimulator.scenario.Scenario;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/**
 * Scenarios: those of files, and those that come with the program, each with what it teaches. For
 * the JavaFX thread.
 */
public final class ScenarioMenu extends MenuButton {

  private final Messages messages;
  private final Language language;
  private final FxScenario scenario;
  private final ScenarioActions actions;
  private final MenuItem nextGroup;
  private boolean listed;

  public ScenarioMenu(ViewContext context) {
    super("", new FontIcon(Feather.FOLDER));
    language = context.language();
    messages = language.messages(ScenarioMenu.class);
    scenario = context.scenario();
    actions = scenario.actions();
    setId("scenarios");
    setFocusTraversable(false);
    getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT, Styles.SMALL, Tweaks.NO_ARROW);
    Tooltips.install(this, messages.text("scenarios-tip"));
    accessibleTextProperty().bind(messages.text("scenarios"));
    MenuItem reload = item("scenario-reload", KeyCode.R, actions::reload);
    reload.setDisable(scenario.plain());
    MenuItem saveAs = item("scenario-save-as", KeyCode.S, this::chooseToSave);
    saveAs.setAccelerator(
        new KeyCodeCombination(KeyCode.S, KeyCombination.SHIFT_DOWN, KeyCombination.SHORTCUT_DOWN));
    nextGroup = item("next-group", KeyCode.N, () -> {});
    nextGroup.setAccelerator(
        new KeyCodeCombination(KeyCode.N, KeyCombination.SHIFT_DOWN, KeyCombination.SHORTCUT_DOWN));
    getItems()
        .setAll(
            item("scenario-open", KeyCode.O, this::chooseToOpen),
            item("scenario-save", KeyCode.S, this::save),
            saveAs,
            reload,
            nextGroup,
            new SeparatorMenuItem());
    setOnShowing(event -> listKnown());
  }

  /** Says what is done for those who come next. */
  public void onNextGroup(Runnable action) {
    nextGroup.setOnAction(event -> action.run());
  }

  /** Lets somebody choose a file, and opens it. */
  public void chooseToOpen() {
    Optional<File> chosen =
        Optional.ofNullable(chooser("scenario-open").showOpenDialog(getScene().getWindow()));
    chosen.map(File::toPath).ifPresent(actions::open);
  }

  /** Writes what is there now to the file from which it came, or lets somebody choose one. */
  public void save() {
    scenario.file().ifPresentOrElse(actions::save, this::chooseToSave);
  }

  /** Lets somebody choose a file, and writes what is there now to it. */
  public void chooseToSave() {
    FileChooser chooser = chooser("scenario-save-as");
    String name =
        scenario.file().map(Path::getFileName).map(Path::toString).orElse(suggestedName());
    chooser.setInitialFileName(name);
    Optional.ofNullable(chooser.showSaveDialog(getScene().getWindow()))
        .map(File::toPath)
        .ifPresent(actions::save);
  }

  private String suggestedName() {
    return messages.now("scenario-name");
  }

  private FileChooser chooser(String title) {
    FileChooser chooser = new FileChooser();
    chooser.setTitle(messages.now(title));
    chooser
        .getExtensionFilters()
        .setAll(new ExtensionFilter(messages.now("scenario-files"), "*.yaml", "*.yml"));
    scenario
        .file()
        .map(Path::toAbsolutePath)
        .map(Path::getParent)
        .map(Path::toFile)
        .filter(File::isDirectory)
        .ifPresent(chooser::setInitialDirectory);
    return chooser;
  }

  private MenuItem item(String id, KeyCode key, Runnable action) {
    MenuItem item = new MenuItem();
    item.setId(id);
    item.textProperty().bind(messages.text(id));
    // only to be seen; the window's keys do it
    item.setAccelerator(new KeyCodeCombination(key, KeyCombination.SHORTCUT_DOWN));
    item.setOnAction(event -> action.run());
    return item;
  }

  /** Reads them only when somebody looks. */
  private void listKnown() {
    if (!listed) {
      listed = true;
      for (String name : Gallery.NAMES) {
        Gallery.find(name).ifPresent(known -> getItems().add(known(name, known)));
      }
    }
  }

  private MenuItem known(String name, Scenario known) {
    Label title = new Label(known.description().name().in(language.locale()));
    title.getStyleClass().add(Styles.TEXT_BOLD);
    Label teaches = new Label(known.description().teaches().in(language.locale()));
    teaches.getStyleClass().addAll(Styles.TEXT_SMALL, Styles.TEXT_MUTED);
    MenuItem item = new CustomMenuItem(new VBox(title, teaches));
    item.setId("scenario-" + name);
    item.setOnAction(event -> actions.openKnown(name));
    return item;
  }
}
