package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import atlantafx.base.theme.Tweaks;
import java.io.File;
import java.nio.file.Path;
import java.util.Arrays;
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
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxScenario;
import tellosimulator.view.model.ScenarioActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;

/** The menu that opens, saves and reloads a scenario's file. Confined to the JavaFX thread. */
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
    Nodes.named(
        this, "scenario-file", Styles.BUTTON_ICON, Styles.FLAT, Styles.SMALL, Tweaks.NO_ARROW);
    Tooltips.install(this, messages.text("scenario-file-tip"));
    accessibleTextProperty().bind(messages.text("scenario-file"));
    textProperty().bind(messages.text("scenario-file"));
    setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
    MenuItem reload = item("scenario-reload", KeyCode.R, actions::reload);
    reload.setDisable(scenario.plain());
    nextGroup = item("next-group", KeyCode.N, () -> {}, KeyCombination.SHIFT_DOWN);
    getItems()
        .setAll(
            item("scenario-open", KeyCode.O, this::chooseToOpen),
            item("scenario-save", KeyCode.S, this::save),
            item("scenario-save-as", KeyCode.S, this::chooseToSave, KeyCombination.SHIFT_DOWN),
            reload,
            nextGroup);
    scenario
        .course()
        .ifPresent(
            seed ->
                getItems()
                    .add(
                        Nodes.menuItem(
                            new MenuItem(),
                            "next-course",
                            messages.text("next-course", Long.toString(seed)),
                            actions::openNextCourse)));
  }

  /** Sets the action that prepares the simulator for the next group. */
  public void onNextGroup(Runnable action) {
    nextGroup.setOnAction(event -> action.run());
  }

  /** Opens a file chooser, and then the chosen file. */
  public void chooseToOpen() {
    Optional<File> chosen =
        Optional.ofNullable(chooser("scenario-open").showOpenDialog(getScene().getWindow()));
    chosen.map(File::toPath).ifPresent(actions::open);
  }

  /**
   * Saves the current state to the scenario's file, or opens a file chooser if there is no file.
   */
  public void save() {
    scenario.file().ifPresentOrElse(actions::save, this::chooseToSave);
  }

  /** Opens a file chooser, and saves the current state to the chosen file. */
  public void chooseToSave() {
    FileChooser chooser = chooser("scenario-save-as");
    String name =
        scenario
            .file()
            .map(Path::getFileName)
            .map(Path::toString)
            .orElse(messages.now("scenario-name"));
    chooser.setInitialFileName(name);
    Optional.ofNullable(chooser.showSaveDialog(getScene().getWindow()))
        .map(File::toPath)
        .ifPresent(actions::save);
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

  private MenuItem item(String id, KeyCode key, Runnable action, KeyCombination.Modifier... more) {
    MenuItem item = Nodes.menuItem(new MenuItem(), id, messages.text(id), action);
    KeyCombination.Modifier[] modifiers = Arrays.copyOf(more, more.length + 1);
    modifiers[more.length] = KeyCombination.SHORTCUT_DOWN;
    // for display only; the window's key bindings handle the key
    item.setAccelerator(new KeyCodeCombination(key, modifiers));
    return item;
  }
}
