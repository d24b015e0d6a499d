package tellosimulator.view.layout;

import atlantafx.base.theme.Styles;
import atlantafx.base.theme.Tweaks;
import javafx.beans.binding.Bindings;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import org.kordamp.ikonli.feather.Feather;
import org.kordamp.ikonli.javafx.FontIcon;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.layout.WindowCommand.Group;
import tellosimulator.view.text.Language;
import tellosimulator.view.text.Messages;

/** The menu of all that the window can do, by groups. For the JavaFX thread. */
final class CommandMenu extends MenuButton {

  private final Messages messages;

  CommandMenu(Language language, WindowCommands commands) {
    super("", new FontIcon(Feather.MENU));
    messages = language.messages(CommandMenu.class);
    setId("commands");
    getStyleClass().addAll(Styles.BUTTON_ICON, Styles.FLAT, Styles.SMALL, Tweaks.NO_ARROW);
    Tooltips.install(this, messages.text("commands-tip"));
    accessibleTextProperty().bind(messages.text("commands-tip"));
    for (Group group : Group.values()) {
      Menu menu = new Menu();
      menu.setId(group.textKey());
      menu.textProperty().bind(messages.text(group.textKey()));
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
