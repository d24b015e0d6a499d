"""A first flight with djitellopy: take off, fly a metre ahead, turn to the right, land.

Start the simulator first, in another terminal:

    mvn javafx:run "-Djavafx.args=--on"

Then start this:

    pip install djitellopy
    python examples/first_flight.py

For a real Tello, leave out the host and the line that sets the address.
"""

from djitellopy import Tello

tello = Tello("127.0.0.1")
tello.address = ("127.0.0.1", 8879)  # the simulator's command port; a real Tello has 8889

tello.connect()
print("Battery:", tello.get_battery(), "%")

tello.takeoff()
try:
    tello.move_forward(100)
    tello.rotate_clockwise(90)
    print("Height:", tello.get_height(), "cm, yaw:", tello.get_yaw(), "degrees")
finally:
    tello.land()
print("Landed.")
