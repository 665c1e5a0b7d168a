# What messages say since the commits that scripts/oracle.sh is run against: old -> new, a line each. It is applied
# to the records of the earlier commit, so that a wording changes on purpose or not at all.
s/\\n  mend:  /\\n  hint:  /g
s/^  mend:  /  hint:  /
s/the rank of the constraints does not fall at the origin, where the equations are expanded/the rank of the constraints falls at the origin, where the equations are expanded/
s/a particle has mass and position, a body inertia besides, and angle or attitude/a particle needs mass and position, a body inertia besides, and angle or attitude/
s/a number has at most 4000 digits and a decimal exponent between -4000 and 4000/the number has more than 4000 digits, or a decimal exponent beyond -4000 ... 4000/
s/a body in space has three principal moments of inertia and three Euler angles/a body in space needs three principal moments of inertia and three Euler angles/
s/the matrix of the accelerations is regular where the equations are expanded/the matrix of the accelerations is singular where the equations are expanded/
s/the interval of verification is positive, and finite in double precision/the interval of verification is not positive, or not finite in double precision/
s/a mechanism has as many quasi-velocities as degrees of freedom, or none/the mechanism has neither as many quasi-velocities as degrees of freedom nor none/
s/a number is an integer, a fraction or a decimal: 12, -3\/4, 0\.25, 1\.5e-3/not a number: it must be an integer, a fraction or a decimal, as 12, -3\/4, 0.25, 1.5e-3/
s/a variable starts from its physical values or from constants, not both/the variable starts both from physical values and from constants/
s/no divisor that was divided by is zero with the values under \[fix\]/a divisor that was divided by is zero with the values under [fix]/
s/a function is declared with the one name that it is a function of/the function is not declared with the one name that it is a function of/
s/a fixed value is zero or lies between 1e-100 and 1e100 in size/the fixed value is neither zero nor between 1e-100 and 1e100 in size/
s/an output is a fast, a slow or a drift variable of the system/the output is not a fast, slow or drift variable of the system/
s/the origin of the fast variables is an equilibrium at eps = 0/the origin of the fast variables is not an equilibrium at eps = 0/
s/a declared function is one of a slow variable or a parameter/a declared function depends on neither a slow variable nor a parameter/
s/a parameter that is given by others has no weight of its own/a parameter computed by [relations] is given a weight of its own/
s/an output is no angle, which is known by its sine and cosine/an angle cannot be an output: it is known by its sine and cosine/
s/a function is an elementary one or stands under \[functions\]/unknown function: neither an elementary one nor one under [functions]/
s/a parameter that \[relations\] gives has no value of its own/a parameter computed by [relations] is given a value of its own/
s/the fast variables in the column of a mode have one weight/the fast variables in the column of the mode have different weights/
s/an expression begins with a number, a name, a sign or '\('/an expression begins with none of number, name, sign and '('/
s/the energy depends on every coordinate and every momentum/the energy does not depend on every coordinate and every momentum/
s/the interval of verification is a real number for eps > 0/the interval of verification is not a real number for eps > 0/
s/each coordinate of a Hamiltonian system has its momentum/the Hamiltonian system has no canonical pairs/
s/the coefficients of the highest derivatives are not zero/the coefficients of the highest derivatives are not proved nonzero/
s/the equations can be solved for the highest derivatives/the equations cannot be solved for the highest derivatives/
s/a quasi-velocity is linear or affine in the velocities/the quasi-velocity is neither linear nor affine in the velocities/
s/the equation of a canonical variable is of first order/the equation of a canonical variable is not of first order/
s/a variable that is not constant at eps = 0 has a role/a variable that is not constant at eps = 0 has no role/
s/a coordinate and its momentum are declared variables/a coordinate or momentum is not a declared variable/
s/only slow variables are declared positive or nonzero/a variable that is not slow is declared positive or nonzero/
s/the derivative of a variable occurs in the equations/the derivative of the variable does not occur in the equations/
s/only variables have derivatives written with primes/primes follow a name that is not a variable/
s/a constraint is linear or affine in the velocities/the constraint is neither linear nor affine in the velocities/
s/a mechanism has fewer constraints than coordinates/the mechanism has as many constraints as coordinates, or more/
s/a mechanism has particles, bodies, or a Lagrangian/the mechanism has no particles, no bodies and no Lagrangian/
s/a drift variable moves slowly: its rate is O\(eps\)/the drift variable does not move slowly: its rate is not O(eps)/
s/a scene outside the folder of its system names it/the scene lies outside the folder of its system and does not name it/
s/a style is poincare, inner_product or hamiltonian/unknown style: the styles are poincare, inner_product and hamiltonian/
s/the columns of the modes are linearly independent/the columns of the modes are not proved linearly independent/
s/the interval of verification is a positive number/the interval of verification is not a positive number/
s/a coordinate and its momentum are fast variables/a coordinate or momentum is not a fast variable/
s/a scene gives time_scale or truncation, not both/the scene gives both time_scale and truncation/
s/the equations determine every highest derivative/the equations do not determine every highest derivative/
s/a variable of a mechanism is one of its motion/the variable does not belong to the motion of the mechanism/
s/an expected verdict is pass, fail or undecided/unknown verdict: pass, fail or undecided can be expected/
s/a start value is finite in double precision/the start value is not finite in double precision/
s/a function has its argument in parentheses/the argument of a function is not in parentheses/
s/a root needs a number that is not negative/the root of a negative number is not real/
s/a start value is a real number for eps > 0/the start value is not a real number for eps > 0/
s/the matrix of the accelerations is regular/the matrix of the accelerations is singular/
s/a setting names a parameter of the system/the setting does not name a parameter of the system/
s/every coordinate that stays is a variable/a coordinate that stays is not a variable/
s/the denominator of a fraction is not zero/the denominator of the fraction is zero/
s/a variable belongs to one canonical pair/the variable belongs to two canonical pairs/
s/a comma has no meaning in an expression/an expression holds a comma/
s/a mechanism has the table \[coordinates\]/the mechanism has no table [coordinates]/
s/the path must be that of a regular file/not a regular file/
s/a quasi-velocity has a name of its own/the name of the quasi-velocity is taken/
s/a relation gives a parameter by others/the relation does not give a parameter by others/
s/a symbol is declared before it is used/unknown symbol/
s/an output is a variable of the system/the output is not a variable of the system/
s/a coordinate is not its own momentum/the coordinate is given as its own momentum/
s/a role is fast, angle, slow or drift/unknown role: the roles are fast, angle, slow and drift/
s/a system file has the table \[system\]/the system file has no table [system]/
s/a function is one of the known ones/unknown function/
s/a Hamiltonian system has an energy/the Hamiltonian system has no energy/
s/a mechanism is regular at eps = 0/the mechanism is singular at eps = 0/
s/a relation has a value at eps = 0/the relation has no value at eps = 0/
s/an equation belongs to a variable/an equation belongs to no variable/
s/each constraint has one integral/a constraint has two integrals/
s/the column of a mode is not zero/the column of the mode is zero/
s/an equation has exactly one '='/the equation does not have exactly one '='/
s/eps of a ladder is listed once/the ladder lists an eps twice/
s/a constraint holds a velocity/the constraint holds no velocity/
s/a product is written with '\*'/a product is written without '*'/
s/a system file has the table \[/the system file has no table [/
s/a state is one of the system/unknown state/
s/every '\(' is closed by a '\)'/a '(' is not closed/
s/a start value is given once/the start value is given twice/
s/a variable has an equation/the variable has no equation/
s/an expression is not empty/the expression is empty/
s/a coordinate has one unit/the coordinate has two units/
s/a denominator is not zero/a denominator is zero/
s/an expression has a value/the expression has no value/
s/the file must be readable/the file cannot be read/
s/an equation is not empty/the equation is empty/
s/an output is listed once/the output is listed twice/
s/a parameter is set once/the parameter is set twice/
s/a setting is NAME=VALUE/the setting is not NAME=VALUE/
s/a system has a variable/the system has no variable/
s/every '\)' closes a '\('/a ')' closes nothing/
s/a slow variable moves/the slow variable does not move/
s/a variable has a role/the variable has no role/
s/a name is used once/the name is used twice/
s/a system has a name/the system has no name/
s/the file must exist/no such file/
s/the file is TOML/the file is not valid TOML/
