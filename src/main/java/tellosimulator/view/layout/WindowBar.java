package tellosimulator.view.layout;

import atlantafx.base.controls.Spacer;
import atlantafx.base.theme.Styles;
import atlantafx.base.theme.Tweaks;
import java.util.List;
import java.util.Locale;
import javafx.beans.binding.Bindings;
import javafx.beans.property.Property;
import javafx.geometry.Orientation;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.Separator;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.ToggleGroup;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.translation.PhraseCatalog;
import tellosimulator.view.controls.LinkButton;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.layout.WindowCommand.Group;
import tellosimulator.view.layout.WindowState.Flag;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;
import tellosimulator.view.world.Simulator3DScene;

/**
 * The bar at the top, with buttons for views, scenarios, parts of the window and settings. Confined
 * to the JavaFX thread.
 */
public final class WindowBar extends LabeledToolBar {

  private final BarButtons buttons;
  private final WindowState state;
  private final ScenarioMenu scenarios;

  public WindowBar(
      ViewContext context, WindowState state, Simulator3DScene scene, PageOverlay pages) {
    this.scenarios = new ScenarioMenu(context);
    this.buttons = new BarButtons(context.language());
    this.state = state;
    setId("window-bar");
    getItems()
        .setAll(
            buttons.button("scenarios", Feather.FOLDER, context.scenario().actions()::choose),
            scenarios,
            new Separator(Orientation.VERTICAL),
            buttons.camera(scene),
            buttons.fit(scene),
            buttons.follow(scene),
            new Separator(Orientation.VERTICAL),
            buttons.inset(scene),
            buttons.trail(scene),
            buttons.goalLine(
                scene,
                context.scenario().challengeProperty().map(asked -> !asked.goals().isEmpty())),
            drones(context),
            buttons.toggle("show-plan", Feather.MAP, state.flag(Flag.PLAN)),
            new Spacer(),
            new SettingsMenu(context.language(), state, scene, pages),
            buttons.button("help", Feather.HELP_CIRCLE, pages::toggleHelp),
            new Separator(Orientation.VERTICAL),
            buttons.part("show-controls", Feather.SLIDERS, state.flag(Flag.SIMULATOR_CONTROLS)),
            buttons.part("show-log", Feather.TERMINAL, state.flag(Flag.LOG)),
            new Separator(Orientation.VERTICAL),
            // always labelled, because users need the address for their programs
            Nodes.styled(
                new LinkButton(context, state.flag(Flag.NETWORK_CONTROLS)),
                Styles.FLAT,
                Styles.SMALL));
  }

  /** Returns the menu of files. */
  public ScenarioMenu scenarios() {
    return scenarios;
  }

  /** Adds a menu of all commands. */
  public void addMenu(Language language, WindowCommands commands) {
    getItems().add(0, new CommandMenu(language, commands));
  }

  private ToggleButton drones(ViewContext context) {
    ToggleButton button = buttons.toggle("show-drones", Feather.LIST, state.flag(Flag.DRONES));
    Nodes.setShown(button, context.simulation().drones().size() > 1);
    return button;
  }

  /** The menu for language, theme, scale, and other settings. Confined to the JavaFX thread. */
  private static final class SettingsMenu extends MenuButton {

    private final Messages messages;

    SettingsMenu(Language language, WindowState state, Simulator3DScene scene, PageOverlay pages) {
      super("", new FontIcon(Feather.SETTINGS));
      messages = language.messages(SettingsMenu.class);
      textProperty().bind(messages.text("settings"));
      setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
      Nodes.named(this, "settings", Styles.BUTTON_ICON, Styles.FLAT, Styles.SMALL, Tweaks.NO_ARROW);
      Nodes.described(this, messages.text("settings"));
      getItems()
          .setAll(
              choice("language", PhraseCatalog.OFFERED, language.localeProperty()),
              choice("theme", List.of(Theme.values()), state.themeProperty()),
              choice("scale", List.of(UiScale.values()), state.uiScaleProperty()),
              flag("smooth-edges", scene.antialiasingProperty()),
              flag("enlarged-drones", scene.dronesEnlargedProperty()),
              flag("reduced-motion", state.flag(Flag.REDUCED_MOTION)),
              flag("record-flights", state.flag(Flag.RECORDED_FLIGHTS)),
              flag("full-screen", state.flag(Flag.FULL_SCREEN)),
              flag("projector", state.flag(Flag.PROJECTOR)),
              Nodes.menuItem(new MenuItem(), "about", messages.text("about"), pages::showAbout));
    }

    private CheckMenuItem flag(String key, Property<Boolean> value) {
      CheckMenuItem item = Nodes.menuItem(new CheckMenuItem(), key, messages.text(key), () -> {});
      item.selectedProperty().bindBidirectional(value);
      return item;
    }

    private <T> Menu choice(String key, List<T> values, Property<T> chosen) {
      Menu menu = Nodes.menuItem(new Menu(), key, messages.text(key), () -> {});
      ToggleGroup group = new ToggleGroup();
      for (T value : values) {
        String id = key + "-" + value.toString().toLowerCase(Locale.ROOT);
        RadioMenuItem item =
            Nodes.menuItem(
                new RadioMenuItem(), id, messages.text(id), () -> chosen.setValue(value));
        item.setToggleGroup(group);
        chosen.subscribe(now -> item.setSelected(value.equals(now)));
        menu.getItems().add(item);
      }
      return menu;
    }
  }

  /** The menu of all commands of the window, by group. Confined to the JavaFX thread. */
  private static final class CommandMenu extends MenuButton {

    private final Messages messages;

    CommandMenu(Language language, WindowCommands commands) {
      super("", new FontIcon(Feather.MENU));
      messages = language.messages(CommandMenu.class);
      Nodes.named(this, "commands", Styles.BUTTON_ICON, Styles.FLAT, Styles.SMALL, Tweaks.NO_ARROW);
      Nodes.described(this, messages.text("commands-tip"));
      for (Group group : Group.values()) {
        String key = group.textKey();
        Menu menu = Nodes.menuItem(new Menu(), key, messages.text(key), () -> {});
        commands.listed().stream()
            .filter(command -> command.group() == group)
            .map(this::item)
            .forEach(menu.getItems()::add);
        getItems().add(menu);
      }
    }

    private MenuItem item(WindowCommand command) {
      MenuItem item = new MenuItem();
      item.textProperty()
          .bind(
              Bindings.createStringBinding(
                  () ->
                      command.title().getValue()
                          + command.key().map(key -> " (" + key.symbols(messages) + ")").orElse(""),
                  command.title()));
      item.setOnAction(event -> command.action().run());
      return item;
    }
  }
}
