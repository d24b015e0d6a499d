package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import atlantafx.base.theme.Tweaks;
import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.stage.FileChooser;
import javafx.stage.FileChooser.ExtensionFilter;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/** Opens, saves and reloads the file of a scenario. For the JavaFX thread. */
public final class ScenarioMenu extends MenuButton {

  private final Messages messages;
  private final FxScenario scenario;
  private final ScenarioActions actions;
  private final MenuItem nextGroup;

  public ScenarioMenu(ViewContext context) {
    super("", new FontIcon(Feather.SAVE));
    messages = context.language().messages(ScenarioMenu.class);
    scenario = context.scenario();
    actions = scenario.actions();
    setId("scenario-file");
    getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT, Styles.SMALL, Tweaks.NO_ARROW);
    Tooltips.install(this, messages.text("scenario-file-tip"));
    accessibleTextProperty().bind(messages.text("scenario-file"));
    textProperty().bind(messages.text("scenario-file"));
    setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
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
            nextGroup);
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
}
