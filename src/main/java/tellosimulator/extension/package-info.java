/**
 * The lights of the extension board of a RoboMaster TT: the state of its lamp and its dot matrix at
 * a moment.
 *
 * <p>A {@link tellosimulator.extension.LightOrder} is the order that a light command contains.
 * {@link tellosimulator.extension.BoardLights} is the state after all orders so far; between
 * orders, it changes only with simulated time. All types are immutable. The package imports {@code
 * time}. The syntax of commands and the rendering of lights belong to other packages.
 */
package tellosimulator.extension;
